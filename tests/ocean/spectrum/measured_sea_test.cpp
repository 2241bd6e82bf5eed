// Seas of measured spectra: from each file to the waves on the device.
//
// Figures of a file are integrated here, from its own frequencies and directions by the trapezoidal rule,
// independently of host/ocean. Energies of the drawn waves are 2 |h0|^2, exponentially distributed with mean
// V and independent, so that first-order scatter of a seed's figures is
//   Hs:    Hs / (2 m0) sqrt(sum (V(K) + V(-K))^2 / 2)    (variance of a patch at one instant: pairs +-K)
//   Tm02:  Tm02 / 2 sqrt(sum V^2 (1/m0 - f^2/m2)^2)
//   theta: sqrt(sum V^2 (a sin - b cos)^2) / (a^2 + b^2),  a, b = sum V cos, sum V sin
// Means of 20 seeds are within 3 / sqrt(20) of it (false alarm 0.27 % each, were seeds not fixed), and their
// spread is within 50 % of it: sqrt(chi^2_19 / 19) is outside [0.5, 1.5] in 0.17 % of cases, so that a
// rescaling of each seed, which has no spread, is found.
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "host/io/spectra/read_spectra.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/ocean.h"
#include "tests/ocean/surface/drawn_modes.h"
#include "tests/ocean/surface/field_statistics.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr int size = 256, seeds = 20;

struct File {
  const char* test_name;
  const char* name;
  double hs_m;  // of the first record, integrated by others, to 5e-4 by their rules
};

void PrintTo(const File& file, std::ostream* out) {
  *out << file.name;
}

/// Hs in m, Tm02 in s, mean direction of travel in rad.
using Figures = std::array<double, 3>;

Figures figures(double m0, double m2, std::complex<double> first_moment) {
  return {4.0 * std::sqrt(m0), std::sqrt(m0 / m2), std::arg(first_moment)};
}

Figures integrated(const WaveSpectrum& record) {
  double m0 = 0.0, m2 = 0.0;
  std::complex<double> first_moment = 0.0;
  const std::size_t directions = record.directions_rad.size();
  const auto moment_at = [&](std::size_t i) {
    std::complex<double> sum = 0.0;
    for (std::size_t j = 0; j < directions; ++j) {
      sum += std::polar(record.spreading[i * directions + j] * 2.0 * pi / static_cast<double>(directions),
                        record.directions_rad[j]);
    }
    return record.energy[i] * sum;
  };
  for (std::size_t i = 0; i + 1 < record.energy.size(); ++i) {
    const double low = record.frequencies_hz[i], high = record.frequencies_hz[i + 1];
    const double e_low = record.energy[i], e_high = record.energy[i + 1], middle = 0.5 * (low + high);
    m0 += 0.5 * (high - low) * (e_low + e_high);
    // f^2 times a straight line: Simpson's rule is exact.
    m2 += (high - low) / 6.0 *
          (low * low * e_low + 2.0 * middle * middle * (e_low + e_high) + high * high * e_high);
    first_moment += 0.5 * (high - low) * (moment_at(i) + moment_at(i + 1));
  }
  return figures(m0, m2, first_moment);
}

// Frequency in Hz and direction of each mode of a cascade.
struct Lattice {
  Lattice(const Cascade& cascade, const Dispersion& dispersion)
      : step_radpm(2.0 * pi / cascade.patch_length_m) {
    for (int i = 0; i < size * size; ++i) {
      const int column = i % size < size / 2 ? i % size : i % size - size;
      const int row = i / size < size / 2 ? i / size : i / size - size;
      const double index = std::hypot(column, row);
      frequency_hz.push_back(index == 0.0 ? 0.0 : dispersion.omega_radps(step_radpm * index) / (2.0 * pi));
      towards.push_back(index == 0.0 ? 0.0 : std::complex<double>(column, row) / index);
    }
  }
  double step_radpm;
  std::vector<double> frequency_hz;
  std::vector<std::complex<double>> towards;
};

class MeasuredSeaTest : public testing::TestWithParam<File> {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("OFFING_TEST_DATA");
    if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA does not name the folder of measured spectra";
    record_ = read_spectra(std::filesystem::path(folder) / "spectra" / GetParam().name)[0];
    spectrum_ = from_measured(record_, {}, {});
    cascades_ = choose_cascades(spectrum_, size);
    for (const Cascade& cascade : cascades_) lattices_.emplace_back(cascade, spectrum_.dispersion);
  }

  // Sums over all waves of all cascades, energies [cascade][mode].
  template <class Energies>
  Figures figures_of(const Energies& energies) const {
    double m0 = 0.0, m2 = 0.0;
    std::complex<double> first_moment = 0.0;
    for (std::size_t c = 0; c < lattices_.size(); ++c) {
      for (std::size_t i = 0; i < energies[c].size(); ++i) {
        const double energy = energies[c][i], f = lattices_[c].frequency_hz[i];
        m0 += energy;
        m2 += energy * f * f;
        first_moment += energy * lattices_[c].towards[i];
      }
    }
    return figures(m0, m2, first_moment);
  }

  // Scatter of one seed's figures around those of the expected energies.
  Figures scatter(const std::vector<std::vector<float>>& variance) const {
    const Figures mean = figures_of(variance);
    const double m0 = std::pow(mean[0] / 4.0, 2.0), m2 = m0 / (mean[1] * mean[1]);
    std::complex<double> first_moment = 0.0;
    for (std::size_t c = 0; c < lattices_.size(); ++c)
      for (std::size_t i = 0; i < variance[c].size(); ++i)
        first_moment += static_cast<double>(variance[c][i]) * lattices_[c].towards[i];
    double height = 0.0, period = 0.0, direction = 0.0;
    for (std::size_t c = 0; c < lattices_.size(); ++c) {
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const auto i = static_cast<std::size_t>(row * size + column);
          const auto opposite = static_cast<std::size_t>((size - row) % size * size + (size - column) % size);
          const double v = variance[c][i], f = lattices_[c].frequency_hz[i];
          height += std::pow(v + variance[c][opposite], 2.0) / 2.0;
          period += std::pow(v * (1.0 / m0 - f * f / m2), 2.0);
          direction += std::pow(v * std::imag(std::conj(first_moment) * lattices_[c].towards[i]), 2.0);
        }
      }
    }
    return {mean[0] / (2.0 * m0) * std::sqrt(height), mean[1] / 2.0 * std::sqrt(period),
            std::sqrt(direction) / std::norm(first_moment)};
  }

  ocl::Device device_ = ocl::Device::open();
  WaveSpectrum record_;
  SeaSpectrum spectrum_;
  std::vector<Cascade> cascades_;
  std::vector<Lattice> lattices_;
};

// Fails if the asked sea is not the file's, or if energy is lost on the way to the modes. Measured: balance
// within 3e-4. Gate 3e-3, the promise to users.
TEST_P(MeasuredSeaTest, HoldsTheEnergyOfTheFile) {
  const Figures file = integrated(record_);
  EXPECT_NEAR(file[0] / GetParam().hs_m, 1.0, 5e-4);
  const SeaState asked = integrate_sea_state(spectrum_);
  EXPECT_NEAR(asked.hs_m / file[0], 1.0, 0.01);
  const Ocean sea(device_, spectrum_, {.size = size, .cascades = cascades_});
  double total_m2 = integrate_sea_state(spectrum_, cascades_.back().k_max_radpm).m0_m2;
  for (std::size_t c = 0; c < cascades_.size(); ++c) {
    const std::vector<float> variance = sea.mode_variance(static_cast<int>(c));
    total_m2 += std::accumulate(variance.begin(), variance.end(), 0.0);
  }
  EXPECT_NEAR(total_m2 / asked.m0_m2, 1.0, 0.003);
  RecordProperty("balance", std::to_string(total_m2 / asked.m0_m2 - 1.0));
}

// Fails if drawn seas are higher, longer or otherwise directed than the file says, or scatter more or less
// than theory: rescaled to the asked height, from a poor generator, or from amplitudes without scatter.
TEST_P(MeasuredSeaTest, SeedsScatterAroundTheFileAsTheoryAsks) {
  const Figures file = integrated(record_);
  Ocean sea(device_, spectrum_, {.size = size, .cascades = cascades_});
  WaveModes modes(device_, spectrum_, cascades_, size, {});
  std::vector<std::vector<float>> variance;
  for (std::size_t c = 0; c < cascades_.size(); ++c)
    variance.push_back(sea.mode_variance(static_cast<int>(c)));
  const Figures expected_scatter = scatter(variance);

  std::array<std::vector<double>, 3> found;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    sea.reseed(seed, {});
    sea.at(0.0);
    modes.draw(seed);
    std::vector<std::vector<double>> energies;
    double height_m2 = 0.0;
    for (int c = 0; c < static_cast<int>(cascades_.size()); ++c) {
      height_m2 += mean_square(sea.read_surface(c).displacement_y);
      energies.emplace_back();
      for (const std::complex<double>& amplitude : drawn_amplitudes(modes, c))
        energies.back().push_back(2.0 * std::norm(amplitude));
    }
    const Figures drawn = figures_of(energies);
    found[0].push_back(4.0 * std::sqrt(height_m2));
    found[1].push_back(drawn[1]);
    found[2].push_back(file[2] + std::remainder(drawn[2] - file[2], 2.0 * pi));
  }
  const char* names[] = {"hs_m", "tm02_s", "direction_rad"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double mean = mean_of(found[i]);
    double square = 0.0;
    for (const double value : found[i]) square += (value - mean) * (value - mean) / (seeds - 1);
    const double error = expected_scatter[i] / std::sqrt(seeds);
    EXPECT_NEAR(mean, file[i], 3.0 * error) << names[i];
    EXPECT_NEAR(std::sqrt(square) / expected_scatter[i], 1.0, 0.5) << names[i];
    RecordProperty(names[i], std::to_string(mean) + " of " + std::to_string(file[i]) + " +- " +
                                 std::to_string(error) + ", spread " +
                                 std::to_string(std::sqrt(square) / expected_scatter[i]));
  }
  EXPECT_LT(expected_scatter[0] / std::sqrt(seeds), 0.015 * file[0]);
}

std::string test_name(const testing::TestParamInfo<File>& info) {
  return info.param.test_name;
}

INSTANTIATE_TEST_SUITE_P(Files, MeasuredSeaTest,
                         testing::Values(File{"ndbc", "41010.data_spec", 1.1188},
                                         File{"ww3", "ww3station.spec", 1.1573},
                                         File{"swan", "swanfile.spec", 1.7164},
                                         File{"datawell_0115", "buoy}2024-09-09T01h15Z.spt", 0.8490},
                                         File{"datawell_0144", "buoy}2024-09-09T01h44Z.spt", 0.9090}),
                         test_name);

}  // namespace
}  // namespace offing::ocean
