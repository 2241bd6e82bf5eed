#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/spectrum/spreading.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

[[noreturn]] void reject(const std::string& what) {
  throw Error(ErrorKind::bad_input, "measured spectrum: " + what,
              "check the record against the format of its file, or choose another record");
}

// Waves of three hours, a hundred times longer than those that wind makes; the shortest capillary ones.
// Closer frequencies than a millionth apart are one frequency that was rounded, and leave no range to
// tabulate.
constexpr double lowest_hz = 1e-4;
constexpr double highest_hz = 100.0;
constexpr double least_step = 1e-6;

/// Where a frequency lies between two listed ones: `upper` is the share of the one above.
struct Place {
  std::size_t index;
  double upper;
};

/// The record, and both linear interpolations of it. Immutable, shared by the callables of the SeaSpectrum.
class MeasuredSea {
 public:
  explicit MeasuredSea(const WaveSpectrum& measured) : record_(measured) {
    check_energy();
    if (record_.is_directional()) {
      check_directions();
      normalise_rows();
      sum_first_moments();
    }
  }

  double energy_m2_per_hz(double frequency_hz) const {
    if (frequency_hz < record_.frequencies_hz.front() || frequency_hz > record_.frequencies_hz.back()) {
      return 0.0;
    }
    const Place place = find(frequency_hz);
    return std::lerp(record_.energy[place.index], record_.energy[place.index + 1], place.upper);
  }

  /// Shares of the two neighbouring rows in D at this frequency: by energy, so that S, not D, is linear. A
  /// frequency without energy then does not dilute its neighbour's directions.
  Place row_shares(double frequency_hz) const {
    Place place = find(frequency_hz);
    const double lower = (1.0 - place.upper) * record_.energy[place.index];
    const double upper = place.upper * record_.energy[place.index + 1];
    if (lower + upper > 0.0) {
      place.upper = upper / (lower + upper);
    }
    return place;
  }

  /// D at the shares of row_shares(), linear in direction.
  double spreading(const Place& shares, double direction_rad) const {
    const std::size_t count = record_.directions_rad.size();
    const double turns = (direction_rad - record_.directions_rad.front()) / (2.0 * pi);
    const double position = (turns - std::floor(turns)) * static_cast<double>(count);
    const std::size_t below = std::min(static_cast<std::size_t>(position), count - 1);
    const std::size_t above = below + 1 == count ? 0 : below + 1;
    const double fraction = position - static_cast<double>(below);
    const double* row = record_.spreading.data() + shares.index * count;
    const double* next_row = row + count;
    return std::lerp(std::lerp(row[below], row[above], fraction),
                     std::lerp(next_row[below], next_row[above], fraction), shares.upper);
  }

  /// First circular moment of D at the shares of row_shares(), of the record's directions.
  std::complex<double> first_moment(const Place& shares) const {
    return (1.0 - shares.upper) * first_moments_[shares.index] +
           shares.upper * first_moments_[shares.index + 1];
  }

  double peak_hz() const {
    const auto largest = std::max_element(record_.energy.begin(), record_.energy.end());
    return record_.frequencies_hz[largest - record_.energy.begin()];
  }

  const std::vector<double>& frequencies_hz() const { return record_.frequencies_hz; }

 private:
  void check_energy() const {
    const std::vector<double>& frequencies_hz = record_.frequencies_hz;
    if (frequencies_hz.size() < 2 || record_.energy.size() != frequencies_hz.size()) {
      reject(fmt::format("expected at least 2 frequencies, each with an energy, found {} and {}",
                         frequencies_hz.size(), record_.energy.size()));
    }
    for (std::size_t i = 0; i < frequencies_hz.size(); ++i) {
      const double least_hz = i == 0 ? lowest_hz : frequencies_hz[i - 1] * (1.0 + least_step);
      if (!(frequencies_hz[i] >= least_hz && frequencies_hz[i] <= highest_hz)) {
        reject(fmt::format(
            "expected frequencies within [{:g}, {:g}] Hz that increase by at least {:g} of themselves, found "
            "{} Hz{}",
            lowest_hz, highest_hz, least_step, frequencies_hz[i],
            i == 0 ? " first" : fmt::format(" after {} Hz", frequencies_hz[i - 1])));
      }
      if (!(record_.energy[i] >= 0.0 && record_.energy[i] <= 1e6)) {
        reject(fmt::format("expected energies within [0, 1e6] m^2/Hz, found {:g} at {:g} Hz",
                           record_.energy[i], frequencies_hz[i]));
      }
    }
    if (!(variance_m2(record_) > 0.0)) {
      reject("expected a sea, found no energy at any frequency");
    }
  }

  void check_directions() const {
    const std::vector<double>& directions_rad = record_.directions_rad;
    const std::size_t count = directions_rad.size();
    if (count < 3 || record_.spreading.size() != count * record_.frequencies_hz.size()) {
      reject(
          fmt::format("expected at least 3 directions and a density for each at every frequency, found {} "
                      "directions and {} densities for {} frequencies",
                      count, record_.spreading.size(), record_.frequencies_hz.size()));
    }
    // Files print directions to a few digits; the grid is taken as even from the first one on.
    const double spacing_rad = 2.0 * pi / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double expected_rad = directions_rad.front() + spacing_rad * static_cast<double>(i);
      if (!(std::abs(directions_rad[i] - expected_rad) <= 0.1 * spacing_rad)) {
        reject(fmt::format(
            "expected {} directions evenly spaced over one turn, found {:g} rad where {:g} is expected",
            count, directions_rad[i], expected_rad));
      }
    }
  }

  void normalise_rows() {
    const std::size_t count = record_.directions_rad.size();
    const double spacing_rad = 2.0 * pi / static_cast<double>(count);
    for (std::size_t i = 0; i < record_.frequencies_hz.size(); ++i) {
      const auto row = record_.spreading.begin() + static_cast<std::ptrdiff_t>(i * count);
      double integral = 0.0;
      for (auto value = row; value != row + static_cast<std::ptrdiff_t>(count); ++value) {
        if (!(*value >= 0.0 && std::isfinite(*value))) {
          reject(fmt::format("expected spreading >= 0, found {:g} at {:g} Hz", *value,
                             record_.frequencies_hz[i]));
        }
        integral += *value * spacing_rad;
      }
      if (record_.energy[i] > 0.0 && std::abs(integral - 1.0) > 0.01) {
        reject(fmt::format("expected a spreading that integrates to 1, found {:g} at {:g} Hz", integral,
                           record_.frequencies_hz[i]));
      }
      // A row without energy may be anything, all zero too: it only matters where both neighbours are calm.
      for (auto value = row; value != row + static_cast<std::ptrdiff_t>(count); ++value) {
        *value = integral > 0.0 ? *value / integral : 0.5 / pi;
      }
    }
  }

  void sum_first_moments() {
    const std::size_t count = record_.directions_rad.size();
    std::vector<std::complex<double>> units;
    for (const double direction_rad : record_.directions_rad) {
      units.push_back(std::polar(2.0 * pi / static_cast<double>(count), direction_rad));
    }
    for (std::size_t i = 0; i < record_.frequencies_hz.size(); ++i) {
      std::complex<double> sum = 0.0;
      for (std::size_t j = 0; j < count; ++j) sum += record_.spreading[i * count + j] * units[j];
      first_moments_.push_back(sum);
    }
  }

  Place find(double frequency_hz) const {
    const std::vector<double>& frequencies_hz = record_.frequencies_hz;
    const auto above = std::upper_bound(frequencies_hz.begin() + 1, frequencies_hz.end() - 1, frequency_hz);
    const std::size_t index = above - frequencies_hz.begin() - 1;
    const double width_hz = frequencies_hz[index + 1] - frequencies_hz[index];
    return {index, std::clamp((frequency_hz - frequencies_hz[index]) / width_hz, 0.0, 1.0)};
  }

  WaveSpectrum record_;
  std::vector<std::complex<double>> first_moments_;  // [nf]
};

// A fully developed sea moves its peak at U10 / 0.83 (Pierson and Moskowitz 1964, its wind brought to 10 m).
constexpr double developed_inverse_wave_age = 0.83;

}  // namespace

SeaSpectrum from_measured(const WaveSpectrum& measured, const SpreadingParameters& spreading,
                          const Dispersion& dispersion) {
  require_valid_dispersion(dispersion);
  const auto sea = std::make_shared<const MeasuredSea>(measured);

  SeaSpectrum spectrum;
  spectrum.dispersion = dispersion;
  spectrum.energy = [sea](double omega_radps) {
    return sea->energy_m2_per_hz(omega_radps / (2.0 * pi)) / (2.0 * pi);
  };
  for (const double frequency_hz : sea->frequencies_hz()) {
    spectrum.kinks_radps.push_back(2.0 * pi * frequency_hz);
  }
  spectrum.omega_min_radps = spectrum.kinks_radps.front();
  spectrum.omega_max_radps = spectrum.kinks_radps.back();
  spectrum.omega_peak_radps = 2.0 * pi * sea->peak_hz();
  if (measured.is_directional()) {
    spectrum.spreading_at = [sea](double omega_radps) -> DirectionalDensity {
      const Place shares = sea->row_shares(omega_radps / (2.0 * pi));
      return [sea, shares](double direction_rad) { return sea->spreading(shares, direction_rad); };
    };
    spectrum.first_moment_at = [sea](double omega_radps) {
      return sea->first_moment(sea->row_shares(omega_radps / (2.0 * pi)));
    };
  } else {
    const double developed_mps =
        developed_inverse_wave_age * dispersion.gravity_mps2 / spectrum.omega_peak_radps;
    spectrum.spreading_at = make_spreading(spreading, spectrum.omega_peak_radps,
                                           std::clamp(developed_mps, 0.1, 100.0), dispersion.gravity_mps2);
  }
  return spectrum;
}

}  // namespace offing::ocean
