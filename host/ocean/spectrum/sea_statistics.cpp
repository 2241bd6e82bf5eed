#include "host/ocean/spectrum/sea_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/density_peak.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

struct Wave {
  double energy_m2, k_radpm, frequency_hz, cosine, sine;
};

void require_valid(const ModeEnergies& modes) {
  if (modes.size < 1 || modes.energy.size() != static_cast<std::size_t>(modes.size) * modes.size ||
      !(modes.patch_length_m > 0.0)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("ocean statistics: expected size x size energies of a patch with a length, found {} "
                    "energies for size {} and {:g} m",
                    modes.energy.size(), modes.size, modes.patch_length_m),
        "pass one energy for each mode, K = 0 first");
  }
}

/// Calls visit(Wave) for every mode that carries energy.
template <typename Visit>
void for_each_mode(std::span<const ModeEnergies> cascades, const Dispersion& dispersion, Visit&& visit) {
  for (const ModeEnergies& modes : cascades) {
    require_valid(modes);
    const int size = modes.size;
    const double step_radpm = 2.0 * pi / modes.patch_length_m;
    const auto wrapped = [size](int index) { return index < size / 2 ? index : index - size; };
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const double energy_m2 = modes.energy[static_cast<std::size_t>(row) * size + column];
        const double index = std::hypot(wrapped(column), wrapped(row));
        if (energy_m2 > 0.0 && index > 0.0) {
          const double k_radpm = step_radpm * index;
          visit(Wave{energy_m2, k_radpm, dispersion.omega_radps(k_radpm) / (2.0 * pi),
                     wrapped(column) / index, wrapped(row) / index});
        }
      }
    }
  }
}

/// Calls visit(Wave) for every mode or Gerstner wave that carries energy.
template <typename Visit>
void for_each_wave(std::span<const ModeEnergies> cascades, const Dispersion& dispersion,
                   std::span<const GerstnerWave> gerstner_waves, Visit&& visit) {
  for_each_mode(cascades, dispersion, visit);
  for (const GerstnerWave& wave : gerstner_waves) {
    if (wave.amplitude_m > 0.0) {
      visit(Wave{0.5 * wave.amplitude_m * wave.amplitude_m, wave.wavenumber_radpm,
                 wave.omega_radps / (2.0 * pi), std::cos(wave.direction_rad), std::sin(wave.direction_rad)});
    }
  }
}

struct Sums {
  double m0 = 0.0, m1 = 0.0, m2 = 0.0, cosine = 0.0, sine = 0.0, slope = 0.0;
  double lowest_hz = INFINITY, highest_hz = 0.0;
};

Sums sum_waves(std::span<const ModeEnergies> cascades, const Dispersion& dispersion,
               std::span<const GerstnerWave> gerstner_waves) {
  Sums sums;
  for_each_wave(cascades, dispersion, gerstner_waves, [&](const Wave& wave) {
    sums.m0 += wave.energy_m2;
    sums.m1 += wave.energy_m2 * wave.frequency_hz;
    sums.m2 += wave.energy_m2 * wave.frequency_hz * wave.frequency_hz;
    sums.cosine += wave.energy_m2 * wave.cosine;
    sums.sine += wave.energy_m2 * wave.sine;
    sums.slope += wave.energy_m2 * wave.k_radpm * wave.k_radpm;
    sums.lowest_hz = std::min(sums.lowest_hz, wave.frequency_hz);
    sums.highest_hz = std::max(sums.highest_hz, wave.frequency_hz);
  });
  return sums;
}

struct Bin {
  double energy_m2 = 0.0;
  double frequency_sum = 0.0;       // of energy times frequency
  double cosine = 0.0, sine = 0.0;  // of energy times direction
  double squares = 0.0;             // of energy
};

/// Bins of frequency from below the lowest wave to above the highest: as wide as this share of their
/// frequency, or as one step of the longest patch's wavenumbers where that is wider.
struct FrequencyBins {
  std::vector<double> edges_hz;
  std::vector<Bin> bins;

  FrequencyBins(double share, std::span<const ModeEnergies> cascades, const Dispersion& dispersion,
                const Sums& sums) {
    double longest_m = 0.0;
    for (const ModeEnergies& modes : cascades) {
      longest_m = std::max(longest_m, modes.patch_length_m);
    }
    edges_hz = {sums.lowest_hz * (1.0 - 1e-9)};
    while (edges_hz.back() <= sums.highest_hz) {
      const double k_radpm = dispersion.wavenumber_radpm(2.0 * pi * edges_hz.back());
      const double lattice_hz = dispersion.group_speed_mps(k_radpm) / longest_m;
      edges_hz.push_back(edges_hz.back() + std::max(share * edges_hz.back(), lattice_hz));
    }
    bins.resize(edges_hz.size() - 1);
  }

  void add(const Wave& wave) {
    const auto above = std::upper_bound(edges_hz.begin(), edges_hz.end(), wave.frequency_hz);
    Bin& bin = bins[above - edges_hz.begin() - 1];
    bin.energy_m2 += wave.energy_m2;
    bin.frequency_sum += wave.energy_m2 * wave.frequency_hz;
    bin.cosine += wave.energy_m2 * wave.cosine;
    bin.sine += wave.energy_m2 * wave.sine;
    bin.squares += wave.energy_m2 * wave.energy_m2;
  }

  double width_hz(std::size_t i) const { return edges_hz[i + 1] - edges_hz[i]; }
};

/// Integral of E^4 over that of f E^4.
double period_of_fourth_power_s(const FrequencyBins& density, double m0_m2) {
  double energy4 = 0.0, frequency_energy4 = 0.0;
  for (std::size_t i = 0; i < density.bins.size(); ++i) {
    const Bin& bin = density.bins[i];
    if (bin.energy_m2 > 0.0) {
      const double weight =
          std::pow(bin.energy_m2 / (m0_m2 * density.width_hz(i)), 4.0) * density.width_hz(i);
      energy4 += weight;
      frequency_energy4 += weight * bin.frequency_sum / bin.energy_m2;
    }
  }
  return energy4 / frequency_energy4;
}

constexpr double fine_share = 0.01;

DensityPeak peak_of(const FrequencyBins& found, const SeaSpectrum& spectrum) {
  std::vector<FrequencyBin> bins;
  for (std::size_t i = 0; i < found.bins.size(); ++i) {
    const Bin& bin = found.bins[i];
    bins.push_back({found.edges_hz[i], found.edges_hz[i + 1], bin.energy_m2,
                    bin.squares > 0.0 ? bin.energy_m2 * bin.energy_m2 / bin.squares : 0.0});
  }
  const auto density_m2phz = [&](double hz) { return 2.0 * pi * spectrum.energy(2.0 * pi * hz); };
  return peak_of(bins, density_m2phz, spectrum.omega_peak_radps / (2.0 * pi));
}

/// Peak period, and direction of the waves within 5 % of its frequency.
void find_peak(const FrequencyBins& density, const SeaSpectrum& spectrum, SeaState& state) {
  const double peak_hz = peak_of(density, spectrum).frequency_hz;
  state.peak_period_s = 1.0 / peak_hz;
  Bin near;
  for (std::size_t i = 0; i < density.bins.size(); ++i) {
    if (density.edges_hz[i + 1] < peak_hz / 1.05 || density.edges_hz[i] > peak_hz * 1.05) continue;
    near.energy_m2 += density.bins[i].energy_m2;
    near.cosine += density.bins[i].cosine;
    near.sine += density.bins[i].sine;
  }
  state.peak_direction_rad = direction_of_moment(near.cosine, near.sine, near.energy_m2);
}

}  // namespace

SeaState sea_state_of(std::span<const ModeEnergies> cascades, const SeaSpectrum& spectrum,
                      std::span<const GerstnerWave> gerstner_waves) {
  const Dispersion& dispersion = spectrum.dispersion;
  const Sums sums = sum_waves(cascades, dispersion, gerstner_waves);
  SeaState state;
  if (sums.m0 <= 0.0) {
    return state;
  }
  state.m0_m2 = sums.m0;
  state.hs_m = 4.0 * std::sqrt(sums.m0);
  const double sixteenth_octave = std::exp2(1.0 / 16.0) - 1.0;
  FrequencyBins coarse_bins(sixteenth_octave, cascades, dispersion, sums);
  FrequencyBins fine_bins(fine_share, cascades, dispersion, sums);
  for_each_wave(cascades, dispersion, gerstner_waves, [&](const Wave& wave) {
    coarse_bins.add(wave);
    fine_bins.add(wave);
  });
  state.tp_s = period_of_fourth_power_s(coarse_bins, sums.m0);
  find_peak(fine_bins, spectrum, state);
  state.tm01_s = sums.m0 / sums.m1;
  state.tm02_s = std::sqrt(sums.m0 / sums.m2);
  state.mean_direction_rad = direction_of_moment(sums.cosine, sums.sine, sums.m0);
  state.spread_rad = spread_of_moment(sums.cosine, sums.sine, sums.m0);
  state.mss = sums.slope;
  return state;
}

SeaStateError standard_error_of(std::span<const ModeEnergies> expected, const SeaSpectrum& spectrum,
                                int seeds, std::span<const GerstnerWave> gerstner_waves) {
  const Dispersion& dispersion = spectrum.dispersion;
  if (seeds < 1) {
    throw Error(ErrorKind::bad_input,
                fmt::format("ocean statistics: expected at least 1 seed, found {}", seeds),
                "average over 1 or more seeds");
  }
  const Sums sums = sum_waves(expected, dispersion, gerstner_waves);
  SeaStateError error;
  if (sums.m0 <= 0.0) {
    return error;
  }
  FrequencyBins bins(fine_share, expected, dispersion, sums);
  const double resultant2 = sums.cosine * sums.cosine + sums.sine * sums.sine;
  double height = 0.0, period = 0.0, direction = 0.0;
  for_each_mode(expected, dispersion, [&](const Wave& wave) {
    const double variance = wave.energy_m2 * wave.energy_m2;
    const double tilt = 1.0 / sums.m0 - wave.frequency_hz * wave.frequency_hz / sums.m2;
    const double turn = sums.cosine * wave.sine - sums.sine * wave.cosine;
    height += variance;
    period += variance * tilt * tilt;
    direction += variance * turn * turn;
    bins.add(wave);
  });
  error.hs_m = 2.0 * std::sqrt(height / (sums.m0 * seeds));
  error.tm02_s = 0.5 * std::sqrt(sums.m0 / sums.m2) * std::sqrt(period / seeds);
  const DensityPeak peak = peak_of(bins, spectrum);
  error.peak_period_s = peak.error / (peak.frequency_hz * std::sqrt(seeds));
  error.mean_direction_rad = resultant2 > 0.0 ? std::sqrt(direction / seeds) / resultant2 : pi;
  return error;
}

}  // namespace offing::ocean
