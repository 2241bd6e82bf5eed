#include "host/ocean/surface/gerstner_waves.h"

#include <limits>
#include <numbers>

#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

GerstnerSea sea_of(std::vector<GerstnerWave> waves, double choppiness) {
  return {.waves = std::move(waves), .choppiness = choppiness};
}

// Fails if a swell runs at another speed than the water's: the sea's own waves of its length would pass it.
TEST(GerstnerWaves, SwellFollowsTheDispersionOfItsWater) {
  const Dispersion deep, shallow{.depth_m = 4.0};
  const Swell swell{.amplitude_m = 0.7, .wavelength_m = 120.0, .direction_rad = 2.0, .phase_rad = 0.3};
  for (const Dispersion& water : {deep, shallow}) {
    const GerstnerWave wave = make_swell(swell, water);
    EXPECT_DOUBLE_EQ(wave.wavenumber_radpm, 2.0 * pi / 120.0);
    EXPECT_DOUBLE_EQ(wave.omega_radps, water.omega_radps(2.0 * pi / 120.0));
    EXPECT_EQ(wave.amplitude_m, 0.7);
    EXPECT_EQ(wave.direction_rad, 2.0);
    EXPECT_EQ(wave.phase_rad, 0.3);
  }
  EXPECT_GT(make_swell(swell, deep).omega_radps, 1.5 * make_swell(swell, shallow).omega_radps);
}

TEST(GerstnerWaves, RejectsSwellsOutOfRange) {
  const auto expect_rejected = [](const Swell& swell, const std::string& name) {
    test::expect_error(ErrorKind::bad_input, name, [&] { make_swell(swell, {}); });
  };
  expect_rejected({.amplitude_m = -0.1}, "swell.amplitude_m");
  expect_rejected({.amplitude_m = not_a_number}, "swell.amplitude_m");
  expect_rejected({.wavelength_m = 0.0}, "swell.wavelength_m");
  expect_rejected({.wavelength_m = 2e5}, "swell.wavelength_m");
  expect_rejected({.direction_rad = not_a_number}, "swell.direction_rad");
  expect_rejected({.phase_rad = std::numeric_limits<double>::infinity()}, "swell.phase_rad");
  test::expect_error(ErrorKind::bad_input, "depth_m", [] { make_swell({}, {.depth_m = -1.0}); });
}

// Fails if a steep sea is let fold, or a gentle one held back, or if the user is told of a limit that does
// not act. k A of both waves together is 0.5: choppiness 2 is the last that fits.
TEST(GerstnerWaves, HorizontalScaleIsLimitedWhereTheSumIsTooSteep) {
  const std::vector<GerstnerWave> waves = {{.amplitude_m = 3.0, .wavenumber_radpm = 0.125},
                                           {.amplitude_m = 0.5, .wavenumber_radpm = 0.25}};
  for (const double choppiness : {0.0, 0.7, 1.0, 2.0}) {
    const HorizontalScale q = horizontal_scale(sea_of(waves, choppiness));
    EXPECT_EQ(q.scale, choppiness);
    EXPECT_EQ(q.steepness, 0.5);
    EXPECT_FALSE(q.is_limited) << choppiness;
  }
  for (const double choppiness : {2.001, 5.0}) {
    const HorizontalScale q = horizontal_scale(sea_of(waves, choppiness));
    EXPECT_EQ(q.scale, 2.0);
    EXPECT_TRUE(q.is_limited) << choppiness;
  }
  const HorizontalScale calm = horizontal_scale(sea_of({}, 1.5));
  EXPECT_EQ(calm.scale, 1.5);
  EXPECT_EQ(calm.steepness, 0.0);
  EXPECT_FALSE(calm.is_limited);
}

// Fails if something out of range reaches the device: it would be a sea of NaN, or an array overrun.
TEST(GerstnerWaves, RejectsSeasOutOfRange) {
  const GerstnerWave good{.amplitude_m = 1.0, .wavenumber_radpm = 0.1, .omega_radps = 1.0};
  EXPECT_NO_THROW(require_valid_gerstner_waves({}));
  EXPECT_NO_THROW(require_valid_gerstner_waves(sea_of(std::vector(128, good), 1.0)));
  const auto expect_rejected = [](const GerstnerSea& sea, const std::string& name) {
    test::expect_error(ErrorKind::bad_input, name, [&] { require_valid_gerstner_waves(sea); });
  };
  expect_rejected(sea_of(std::vector(129, good), 1.0), "gerstner wave count");
  expect_rejected(sea_of({good}, -0.1), "choppiness");
  expect_rejected(sea_of({good}, not_a_number), "choppiness");
  expect_rejected({.loop_period_s = 0.01}, "loop_period_s");
  expect_rejected({.dispersion = {.gravity_mps2 = 0.0}}, "gravity_mps2");
  const auto with = [&](double GerstnerWave::*member, double value) {
    GerstnerWave wave = good;
    wave.*member = value;
    return sea_of({good, wave}, 1.0);
  };
  expect_rejected(with(&GerstnerWave::amplitude_m, -1.0), "gerstner.amplitude_m");
  expect_rejected(with(&GerstnerWave::amplitude_m, not_a_number), "gerstner.amplitude_m");
  expect_rejected(with(&GerstnerWave::wavenumber_radpm, 0.0), "gerstner.wavenumber_radpm");
  expect_rejected(with(&GerstnerWave::wavenumber_radpm, 100.0), "gerstner.wavenumber_radpm");
  expect_rejected(with(&GerstnerWave::direction_rad, not_a_number), "gerstner.direction_rad");
  expect_rejected(with(&GerstnerWave::omega_radps, -1.0), "gerstner.omega_radps");
  expect_rejected(with(&GerstnerWave::phase_rad, not_a_number), "gerstner.phase_rad");
  const auto drop = [](const Raindrop& raindrop) { return GerstnerSea{.raindrops = {raindrop}}; };
  EXPECT_NO_THROW(require_valid_gerstner_waves(drop({})));
  EXPECT_NO_THROW(require_valid_gerstner_waves({.raindrops = std::vector<Raindrop>(4096)}));
  expect_rejected({.raindrops = std::vector<Raindrop>(4097)}, "raindrop count");
  expect_rejected(drop({.x_m = not_a_number}), "raindrop.x_m");
  expect_rejected(drop({.z_m = 1e10}), "raindrop.z_m");
  expect_rejected(drop({.time_s = not_a_number}), "raindrop.time_s");
  expect_rejected(drop({.amplitude_m = 1e3}), "raindrop.amplitude_m");
  expect_rejected(drop({.wavelength_m = 0.0}), "raindrop.wavelength_m");
  expect_rejected(drop({.decay_s = 0.0}), "raindrop.decay_s");
}

}  // namespace
}  // namespace offing::ocean
