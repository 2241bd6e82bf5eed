#include "host/ocean/spectrum/spectrum_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "tests/ocean/example_seas.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

/// The table as the device reads it: linear in ln k and periodic direction, zero beyond the first and last
/// row.
double interpolate(const SpectrumTable& table, double log_k, double direction_rad) {
  const double row = (log_k - table.log_k_first) / table.log_k_step;
  if (row < 0.0 || row >= table.wavenumber_count - 1) {
    return 0.0;
  }
  const double turns = direction_rad / (2.0 * pi);
  const double column = (turns - std::floor(turns)) * table.direction_count;
  const int i = static_cast<int>(row);
  const int j = static_cast<int>(column) % table.direction_count;
  const auto value = [&](int k, int d) -> double {
    return table.values[static_cast<std::size_t>(k) * table.direction_count + d % table.direction_count];
  };
  const double upper = row - i, right = column - std::floor(column);
  return std::lerp(std::lerp(value(i, j), value(i, j + 1), right),
                   std::lerp(value(i + 1, j), value(i + 1, j + 1), right), upper);
}

struct TableMoments {
  double m0 = 0.0, m1 = 0.0, cosine = 0.0, sine = 0.0;
};

// Sums of a bilinear function over equal cells are exact: no error of the test's own for m0. For the others,
// midpoints of half cells.
TableMoments moments_of(const SpectrumTable& table, const Dispersion& dispersion) {
  TableMoments moments;
  const double step_rad = 2.0 * pi / table.direction_count;
  for (int i = 0; i < 2 * (table.wavenumber_count - 1); ++i) {
    const double log_k = table.log_k_first + (0.5 * i + 0.25) * table.log_k_step;
    const double frequency_hz = dispersion.omega_radps(std::exp(log_k)) / (2.0 * pi);
    for (int j = 0; j < 2 * table.direction_count; ++j) {
      const double direction_rad = (0.5 * j + 0.25) * step_rad;
      const double energy = interpolate(table, log_k, direction_rad) * 0.25 * table.log_k_step * step_rad;
      moments.m0 += energy;
      moments.m1 += energy * frequency_hz;
      moments.cosine += energy * std::cos(direction_rad);
      moments.sine += energy * std::sin(direction_rad);
    }
  }
  return moments;
}

// The table is what the sea is made from: its energy, mean period and direction are the spectrum's. The
// promise is 1e-4 of m0. Measured: 4e-10 for m0 (float rounding), 6e-6 for the mean period (interpolation
// widens a row by h^2 / 3, h = 1.3 %), 6e-7 rad for the direction. Gates 1e-6, 2e-5, 1e-5: sampling rows
// instead of gathering energy into them is off by 1e-2 for the spiky record.
TEST(SpectrumTable, IntegratesToTheSpectrum) {
  for (const ExampleSea& sea : example_seas()) {
    const SeaState state = integrate_sea_state(sea.spectrum);
    const SpectrumTable table = tabulate(sea.spectrum);
    ASSERT_EQ(table.values.size(), static_cast<std::size_t>(table.wavenumber_count) * table.direction_count);
    const TableMoments moments = moments_of(table, sea.spectrum.dispersion);
    EXPECT_NEAR(moments.m0 / state.m0_m2, 1.0, 1e-6) << sea.name;
    EXPECT_NEAR(moments.m0 / moments.m1 / state.tm01_s, 1.0, 2e-5) << sea.name;
    if (std::hypot(moments.cosine, moments.sine) > 1e-3 * moments.m0) {
      const double direction_rad = std::atan2(moments.sine, moments.cosine);
      EXPECT_NEAR(std::remainder(direction_rad - state.mean_direction_rad, 2.0 * pi), 0.0, 1e-5) << sea.name;
    }
  }
}

// Energy stays where it is: below any wavenumber the table holds the spectrum's share, but for what the rows
// beside it exchange: h times the change of T from row to row. Measured 2.5e-4 of m0, gate 1e-3; a shift by
// half a row is 5e-3.
TEST(SpectrumTable, KeepsEnergyInItsBand) {
  for (const ExampleSea& sea : example_seas()) {
    const SpectrumTable table = tabulate(sea.spectrum);
    const double m0 = integrate_sea_state(sea.spectrum).m0_m2;
    const double step_rad = 2.0 * pi / table.direction_count;
    double below = 0.0;
    int next_check = 128;
    for (int i = 0; i < table.wavenumber_count; ++i) {
      double row = 0.0;
      for (int j = 0; j < table.direction_count; ++j) {
        row += table.values[static_cast<std::size_t>(i) * table.direction_count + j] * step_rad *
               table.log_k_step;
      }
      if (i == next_check) {
        const double k_radpm = std::exp(table.log_k_first + i * table.log_k_step);
        const double expected = integrate_sea_state(sea.spectrum, 0.0, k_radpm).m0_m2;
        EXPECT_NEAR((below + 0.5 * row) / m0, expected / m0, 1e-3) << sea.name << " row " << i;
        next_check += 128;
      }
      below += row;
    }
  }
}

// Where the spectrum is smooth the table is the spectrum itself: T = S d omega / d ln k. Interpolation
// between directions may err by 1 % of a row's maximum (the table's own choice of directions), half of it at
// these samples; gathering along k by h^2 / 6 of the curvature, 2e-3 at JONSWAP's peak with gamma 7.
// Measured 4.3e-3.
TEST(SpectrumTable, FollowsASmoothDensity) {
  for (const ExampleSea& sea : example_seas()) {
    if (sea.name == "measured, spiky") {
      continue;
    }
    const SpectrumTable table = tabulate(sea.spectrum);
    const float largest = *std::max_element(table.values.begin(), table.values.end());
    const Dispersion& dispersion = sea.spectrum.dispersion;
    double worst = 0.0;
    for (int i = 20; i < table.wavenumber_count - 20; i += 5) {
      const double k_radpm = std::exp(table.log_k_first + (i + 0.3) * table.log_k_step);
      const double omega_radps = dispersion.omega_radps(k_radpm);
      for (double direction_rad = 0.013; direction_rad < 2.0 * pi; direction_rad += 0.1) {
        const double exact =
            sea.spectrum.density(omega_radps, direction_rad) * dispersion.group_speed_mps(k_radpm) * k_radpm;
        worst = std::max(worst, std::abs(interpolate(table, std::log(k_radpm), direction_rad) - exact));
      }
    }
    EXPECT_LT(worst, 5e-3 * largest) << sea.name;
  }
}

TEST(SpectrumTable, OuterRowsAreEmpty) {
  for (const ExampleSea& sea : example_seas()) {
    const SpectrumTable table = tabulate(sea.spectrum);
    for (int j = 0; j < table.direction_count; ++j) {
      EXPECT_EQ(table.values[j], 0.0f) << sea.name;
      EXPECT_EQ(table.values[table.values.size() - 1 - j], 0.0f) << sea.name;
    }
    for (const float value : table.values) {
      ASSERT_TRUE(std::isfinite(value) && value >= 0.0f) << sea.name;
    }
  }
}

// Fails if a spectrum without a range of frequencies is divided by its width, which once wrote outside the
// table.
TEST(SpectrumTable, RejectsASpectrumWithoutRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [low_radps, high_radps] :
       {std::pair{0.3, 0.3}, {0.5, 0.3}, {0.0, 1.0}, {-1.0, 1.0}, {0.3, infinity}, {infinity, infinity}}) {
    SeaSpectrum spectrum = make_sea_spectrum({});
    spectrum.omega_min_radps = low_radps;
    spectrum.omega_max_radps = high_radps;
    EXPECT_THROW(tabulate(spectrum), Error) << low_radps << " ... " << high_radps;
  }
}

}  // namespace
}  // namespace offing::ocean
