// Seas that repeat.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "tests/ocean/surface/drawn_modes.h"
#include "tests/ocean/surface/field_statistics.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

constexpr int size = 256;

class OceanLoopTest : public testing::Test {
 protected:
  OceanParameters parameters(std::optional<double> loop_period_s) const {
    return {.size = size,
            .cascades = cascades_from_patches(std::vector{150.0, 23.0}, size),
            .loop_period_s = loop_period_s};
  }
  WaveModes modes(double loop_period_s) const {
    return WaveModes(device_, spectrum_, parameters({}).cascades, size, loop_period_s);
  }

  ocl::Device device_ = ocl::Device::open();
  SeaSpectrum spectrum_ = make_sea_spectrum({});
};

void expect_identical(const SurfaceFields& found, const SurfaceFields& expected) {
  EXPECT_EQ(found.displacement_x, expected.displacement_x);
  EXPECT_EQ(found.displacement_y, expected.displacement_y);
  EXPECT_EQ(found.displacement_z, expected.displacement_z);
  EXPECT_EQ(found.slope_x, expected.slope_x);
  EXPECT_EQ(found.slope_z, expected.slope_z);
  EXPECT_EQ(found.gradient_xx, expected.gradient_xx);
  EXPECT_EQ(found.gradient_xz, expected.gradient_xz);
  EXPECT_EQ(found.gradient_zz, expected.gradient_zz);
}

// Fails if the first frame of the next turn differs in a single bit from that of this one: a visible jump,
// and files that differ. T dyadic, decimal, and a whole number of frames at 24 a second.
TEST_F(OceanLoopTest, RepeatsBitForBit) {
  for (const double period_s : {8.0, 3.3, 125.0 / 24.0}) {
    Ocean sea(device_, spectrum_, parameters(period_s));
    for (const double time_s : {0.0, 1.0 / 24.0, 2.5, 77.0 / 24.0}) {
      sea.at(time_s);
      const SurfaceFields first = sea.read_surface(0), first_short = sea.read_surface(1);
      for (const double turns : {1.0, 2.0, 7.0, -3.0}) {
        sea.at(time_s + turns * period_s);
        expect_identical(sea.read_surface(0), first);
        expect_identical(sea.read_surface(1), first_short);
      }
    }
    sea.at(0.5 * period_s);
    EXPECT_GT(mean_square(sea.read_surface(0).displacement_y), 0.0);
  }
}

// Fails if rounding of t and t + T shows. Instants are T / 2^28 apart; frame times up to 2000 s are rounded
// by 1.1e-13 s, so that one frame in 2^28 2e-13 s / T = 1e-5 could fall between two instants, were they
// spread at random: these do not.
TEST_F(OceanLoopTest, EveryFrameOfALongBakeRepeats) {
  for (const double period_s : {5.0, 3.3, 17.337, 100.0}) {
    const WaveModes modes = this->modes(period_s);
    for (int frame = 0; frame < 24000; ++frame) {
      const double time_s = frame / 24.0;
      const WaveTime now = modes.clock().at(time_s), later = modes.clock().at(time_s + period_s);
      ASSERT_EQ(now.ticks, later.ticks) << frame << " " << period_s;
      ASSERT_EQ(now.tick_fraction, later.tick_fraction);
    }
  }
}

// Fails if a wave does not make a whole number of cycles in T, stands still, or is moved further than to the
// nearest whole number: |f - f_exact| <= 1 / 2T, except that the slowest make one cycle.
TEST_F(OceanLoopTest, EveryWaveMakesWholeCycles) {
  const double period_s = 12.0;
  const WaveModes modes = this->modes(period_s);
  EXPECT_NEAR(modes.clock().radps_per_rate() * period_s, 2.0 * std::numbers::pi, 1e-12);
  const std::vector<std::uint32_t> rates = drawn_rates(modes, 0);
  const double step_radpm = 2.0 * std::numbers::pi / 150.0;
  for (int row = -size / 2 + 1; row < size / 2; ++row) {
    for (int column = -size / 2 + 1; column < size / 2; ++column) {
      if (row == 0 && column == 0) continue;
      const double exact = spectrum_.dispersion.omega_radps(step_radpm * std::hypot(column, row)) /
                           modes.clock().radps_per_rate();
      const double rate =
          rates[static_cast<std::size_t>((row + size) % size * size + (column + size) % size)];
      EXPECT_NEAR(rate, std::max(exact, 0.5), 0.5 + 1e-9);
      EXPECT_GE(rate, 1.0);
    }
  }
}

// Fails if a loop changes the sea itself: at t = 0 it is the free sea, bit for bit, and later it has the same
// height. Frequencies move by at most 1 / 2T = 0.042 Hz, which leaves amplitudes alone. The mean of 16 seeds
// of m0 at t = 5 s differs between the two only as two samples of one sea do: m0 of a seed scatters by s =
// sqrt(sum (V(K) + V(-K))^2 / 2), and the difference of two means by at most s sqrt(2 / 16); gate three of
// them (false alarm 0.3 % if seeds were not fixed).
TEST_F(OceanLoopTest, KeepsTheSeaState) {
  Ocean free(device_, spectrum_, parameters({})), looping(device_, spectrum_, parameters(12.0));
  free.at(0.0);
  looping.at(0.0);
  expect_identical(looping.read_surface(0), free.read_surface(0));

  const std::vector<float> variance = free.mode_variance(0);
  double scatter = 0.0;
  for (int i = 0; i < size * size; ++i) {
    const int opposite = (size - i / size) % size * size + (size - i % size) % size;
    scatter += std::pow(variance[i] + variance[opposite], 2.0) / 2.0;
  }
  double difference_m2 = 0.0;
  constexpr int seeds = 16;
  for (int seed = 1; seed <= seeds; ++seed) {
    for (Ocean* sea : {&free, &looping}) {
      sea->reseed(seed, {});
      sea->at(5.0);
      difference_m2 +=
          (sea == &looping ? 1.0 : -1.0) * mean_square(sea->read_surface(0).displacement_y) / seeds;
    }
  }
  EXPECT_LT(std::abs(difference_m2), 3.0 * std::sqrt(scatter * 2.0 / seeds));
}

// Fails if a loop takes waves that it cannot show: 2^28 instants a turn are coarse for one that makes
// millions of cycles in it. The fastest wave here has 83 Hz, so that 2^22 cycles take 14 hours.
TEST_F(OceanLoopTest, RefusesMoreCyclesThanItResolves) {
  const std::vector<Cascade> short_patch = {{0.01, 0.0, 1e9}};
  const auto make = [&](double period_s) { return WaveModes(device_, spectrum_, short_patch, 64, period_s); };
  const std::string hint = test::expect_error(
      ErrorKind::bad_input, "expected at most 50696 s for waves of 82.7 Hz", [&] { make(86400.0); });
  EXPECT_THAT(hint, testing::HasSubstr("set loop_period_s to 50696 or less"));
  EXPECT_NO_THROW(make(50600.0));
}

}  // namespace
}  // namespace offing::ocean
