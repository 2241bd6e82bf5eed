#include "host/ocean/query/gerstner_instant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/ocean/surface/gerstner_surface.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

GerstnerSea sea() {
  GerstnerSea sea{.raindrops = {{.x_m = 3.0, .z_m = 4.0, .time_s = 4.0, .wavelength_m = 2.0, .decay_s = 9.0},
                                {.time_s = 1e6}},
                  .choppiness = 0.7,
                  .dispersion = {.depth_m = 8.0}};
  for (int i = 0; i < 12; ++i) {
    sea.waves.push_back(make_swell({.amplitude_m = 0.1 + 0.02 * i,
                                    .wavelength_m = 9.0 + 8.0 * i,
                                    .direction_rad = 0.9 * i,
                                    .phase_rad = 1.3 * i},
                                   sea.dispersion));
  }
  return sea;
}

// Fails if the sums on the host and on the device are not those of the same sea: a query would float beside
// the surface that is drawn. Bounds and gate as in gerstner_surface_test.cpp, 1e-6 of the sums of the waves'
// largest values; rings 3e-5 (raindrops_test.cpp).
TEST(GerstnerInstant, IsWhatTheDeviceDraws) {
  const SampleGrid grid{.origin_x_m = -7.3,
                        .origin_z_m = 2.1,
                        .spacing_x_m = 0.31,
                        .spacing_z_m = 0.17,
                        .columns = 70,
                        .rows = 30};
  GerstnerSurface surface(ocl::Device::open());
  for (const std::optional<double> loop_period_s : {std::optional<double>(), std::optional(17.3)}) {
    GerstnerSea asked = sea();
    asked.loop_period_s = loop_period_s;
    double heights_m = 0.05, slopes = 0.1;
    for (const GerstnerWave& wave : asked.waves) {
      heights_m += wave.amplitude_m;
      slopes += wave.amplitude_m * wave.wavenumber_radpm;
    }
    for (const double time_s : {-2.0, 6.0, 54321.0}) {
      surface.at(asked, grid, time_s);
      const GerstnerFields fields = surface.read();
      const GerstnerInstant instant(asked, time_s);
      double worst = 0.0;
      for (int i = 0; i < grid.rows * grid.columns; ++i) {
        const GerstnerValues values = instant.at(grid.origin_x_m + i % grid.columns * grid.spacing_x_m,
                                                 grid.origin_z_m + i / grid.columns * grid.spacing_z_m);
        const auto compare = [&](double host, float device, double size) {
          worst = std::max(worst, std::abs(host - device) / size);
        };
        compare(values.displacement_x_m, fields.displacement_x[i], heights_m);
        compare(values.displacement_y_m, fields.displacement_y[i], heights_m);
        compare(values.displacement_z_m, fields.displacement_z[i], heights_m);
        compare(values.slope_x, fields.slope_x[i], slopes);
        compare(values.slope_z, fields.slope_z[i], slopes);
        compare(values.gradient_xx, fields.gradient_xx[i], slopes);
        compare(values.gradient_xz, fields.gradient_xz[i], slopes);
        compare(values.gradient_zz, fields.gradient_zz[i], slopes);
      }
      EXPECT_LT(worst, 1.5e-6) << time_s;
      RecordProperty("worst", std::to_string(worst * 1e9) + "e-9");
    }
  }
}

// Fails if velocities are not those of the particles that the displacement moves: at the surface of deep
// water and with Q = 1 they are its rate of change, here by differences over 2 ms: (omega dt)^2 / 6 = 1e-6.
TEST(GerstnerInstant, VelocityIsTheDisplacementsRateOfChange) {
  GerstnerSea deep = sea();
  deep.raindrops.clear();
  deep.dispersion = {};
  deep.choppiness = 1.0;
  ASSERT_FALSE(horizontal_scale(deep).is_limited);
  constexpr double step_s = 1e-3;
  const GerstnerInstant before(deep, 5.0 - step_s), now(deep, 5.0), after(deep, 5.0 + step_s);
  for (const double x_m : {0.0, 3.3, 71.0}) {
    const GerstnerValues a = before.at(x_m, -2.0), b = after.at(x_m, -2.0);
    const ParticleVelocity velocity = now.velocity(x_m, -2.0, 0.0);
    EXPECT_NEAR(velocity.x_mps, (b.displacement_x_m - a.displacement_x_m) / (2.0 * step_s), 1e-5);
    EXPECT_NEAR(velocity.y_mps, (b.displacement_y_m - a.displacement_y_m) / (2.0 * step_s), 1e-5);
    EXPECT_NEAR(velocity.z_mps, (b.displacement_z_m - a.displacement_z_m) / (2.0 * step_s), 1e-5);
  }
}

// Fails if waves do not feel the bed: there nothing moves up or down, and one long wave moves all water
// between as shallow water does, evenly; deep below short waves nothing moves at all.
TEST(GerstnerInstant, VelocityFeelsTheBed) {
  const Dispersion shallow{.depth_m = 2.0};
  const GerstnerSea sea{.waves = {make_swell({.wavelength_m = 500.0, .phase_rad = 0.4}, shallow)},
                        .dispersion = shallow};
  const GerstnerInstant instant(sea, 3.0);
  const ParticleVelocity top = instant.velocity(10.0, 0.0, 0.0), bed = instant.velocity(10.0, 0.0, 2.0);
  EXPECT_NEAR(bed.y_mps, 0.0, 1e-12);
  EXPECT_NE(top.y_mps, 0.0);
  EXPECT_NEAR(bed.x_mps / top.x_mps, 1.0 / std::cosh(2.0 * std::numbers::pi / 500.0 * 2.0), 1e-12);
  // Shallow water: the speed is h sqrt(g / D), within (k D)^2 = 6e-4.
  EXPECT_NEAR(top.x_mps, instant.at(10.0, 0.0).displacement_y_m * std::sqrt(9.81 / 2.0), 1e-3);
  const GerstnerInstant deep({.waves = {make_swell({.wavelength_m = 3.0}, {})}}, 3.0);
  EXPECT_NEAR(deep.velocity(0.0, 0.0, 10.0).x_mps, 0.0, 1e-8);
  test::expect_error(ErrorKind::bad_input, "depth_m", [&] { instant.velocity(0.0, 0.0, 2.1); });
}

TEST(GerstnerInstant, RejectsWhatItCannotSum) {
  test::expect_error(ErrorKind::bad_input, "time_s", [] { GerstnerInstant({}, 1e9); });
  GerstnerSea bad = sea();
  bad.waves[1].phase_rad = std::numeric_limits<double>::quiet_NaN();
  test::expect_error(ErrorKind::bad_input, "gerstner.phase_rad", [&] { GerstnerInstant(bad, 0.0); });
}

}  // namespace
}  // namespace offing::ocean
