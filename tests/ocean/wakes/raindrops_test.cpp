// Rings of raindrops on the device against their definition in double precision, for both kernel shapes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/ocean/surface/gerstner_surface.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

class RaindropTest : public testing::TestWithParam<const char*> {
 protected:
  RaindropTest() : shape_("OFFING_SHAPE", GetParam()), surface_(ocl::Device::open()) {}

  GerstnerFields fields_at(const GerstnerSea& sea, const SampleGrid& grid, double time_s) {
    surface_.at(sea, grid, time_s);
    return surface_.read();
  }

  test::ScopedEnvironment shape_;
  GerstnerSurface surface_;
};

// h of a ring by the text of kernels/ocean/gerstner_surface.cl, and the sum of all of them at a label.
double ring_height(const Raindrop& drop, const Dispersion& dispersion, double x_m, double z_m,
                   double time_s) {
  const double age_s = time_s - drop.time_s;
  if (age_s < 0.0) return 0.0;
  const double l = drop.wavelength_m, k = 2.0 * pi / l, rounding_m = l / 4.0;
  const double r = std::hypot(std::hypot(x_m - drop.x_m, z_m - drop.z_m), rounding_m) - rounding_m;
  const double u = (r - dispersion.group_speed_mps(k) * age_s) / l;
  return drop.amplitude_m * std::exp(-age_s / drop.decay_s) * std::sqrt(l / (l + r)) *
         std::exp(-0.25 * u * u) * std::cos(k * r - dispersion.omega_radps(k) * age_s);
}

// Fails if rings move, spread, fade or turn otherwise than said, if their slopes are not those of their
// heights (differences of the definition over 2e-5 m), or if drops move before they fall. Phases of a ring
// are 2^-19 of a turn apart (4 bits before the point of a 24-bit mantissa): 2 pi 2^-20 = 6e-6 of the
// amplitude; gate 3e-5 of the sum of amplitudes, and of the slopes k A.
TEST_P(RaindropTest, RaindropsSetOffRings) {
  const Dispersion water{.capillary_length_m = 2.73e-3};
  GerstnerSea sea{.raindrops = {{.x_m = -35.0, .z_m = 12.7, .time_s = 1.0, .amplitude_m = 0.02},
                                {.x_m = -36.0,
                                 .z_m = 13.0,
                                 .time_s = 0.5,
                                 .amplitude_m = -0.03,
                                 .wavelength_m = 0.35,
                                 .decay_s = 2.0},
                                {.x_m = -35.5, .z_m = 12.9, .time_s = 9.0, .amplitude_m = 0.05}},
                  .dispersion = water};
  const SampleGrid grid{.origin_x_m = -37.3,
                        .origin_z_m = 11.9,
                        .spacing_x_m = 0.02,
                        .spacing_z_m = 0.03,
                        .columns = 200,
                        .rows = 80};
  double worst_of_all = 0.0;
  for (const double time_s : {0.4, 1.0, 1.3, 2.5, 4.0}) {
    const GerstnerFields fields = fields_at(sea, grid, time_s);
    const auto height = [&](double x_m, double z_m) {
      double sum = 0.0;
      for (const Raindrop& drop : sea.raindrops) sum += ring_height(drop, water, x_m, z_m, time_s);
      return sum;
    };
    double worst = 0.0, worst_slope = 0.0, highest = 0.0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const auto i = static_cast<std::size_t>(row * grid.columns + column);
        const double x = grid.origin_x_m + column * grid.spacing_x_m;
        const double z = grid.origin_z_m + row * grid.spacing_z_m;
        constexpr double step_m = 1e-5;
        const double sx = (height(x + step_m, z) - height(x - step_m, z)) / (2.0 * step_m);
        const double sz = (height(x, z + step_m) - height(x, z - step_m)) / (2.0 * step_m);
        highest = std::max(highest, std::abs(height(x, z)));
        worst = std::max(worst, std::abs(fields.displacement_y[i] - height(x, z)));
        worst_slope =
            std::max({worst_slope, std::abs(fields.slope_x[i] - sx), std::abs(fields.slope_z[i] - sz)});
        ASSERT_EQ(fields.displacement_x[i], 0.0f);
        ASSERT_EQ(fields.gradient_xx[i], 0.0f);
      }
    }
    EXPECT_LT(worst, 3e-5 * 0.05) << time_s;
    EXPECT_LT(worst_slope, 3e-5 * 2.0 * pi * (0.02 / 0.2 + 0.03 / 0.35)) << time_s;
    if (time_s < 0.5) {
      EXPECT_EQ(highest, 0.0);
    }
    if (time_s == 1.0) {
      EXPECT_GT(highest, 0.015);
    }
    worst_of_all = std::max(worst_of_all, worst / 0.05);
  }
  RecordProperty("worst", std::to_string(worst_of_all * 1e9) + "e-9");
}

// Fails if rings are drawn on a grid too coarse for them.
TEST_P(RaindropTest, RingsFadeWhereTheGridIsCoarse) {
  const GerstnerSea sea{.raindrops = {{.amplitude_m = 0.05, .wavelength_m = 0.5}}};
  const SampleGrid coarse{.spacing_x_m = 0.3, .spacing_z_m = 0.3, .columns = 20, .rows = 20};
  for (const float height : fields_at(sea, coarse, 0.1).displacement_y) ASSERT_EQ(height, 0.0f);
}

std::string shape_name(const testing::TestParamInfo<const char*>& info) {
  return info.param;
}

INSTANTIATE_TEST_SUITE_P(Shapes, RaindropTest, testing::Values("simd", "workgroup"), shape_name);

}  // namespace
}  // namespace offing::ocean
