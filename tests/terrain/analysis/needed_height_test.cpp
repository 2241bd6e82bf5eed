// Heights that are needed to be seen, against viewsheds of targets of one height.
#include "host/terrain/analysis/needed_height.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "host/terrain/field/height_field.h"

namespace offing::terrain {
namespace {

HeightMap hilly_map() {
  HeightMap map{.columns = 97,
                .rows = 71,
                .spacing_x_m = 30.0,
                .spacing_z_m = 20.0,
                .heights_m = {},
                .is_void = {},
                .georeference = {}};
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column)
      map.heights_m.push_back(
          static_cast<float>(60.0 * std::sin(0.31 * column) * std::cos(0.23 * row) + 0.4 * column));
  }
  return map;
}

// A target of some height is seen from where the needed height is less, and hidden where it is more. Fails if
// the two differ by more than rounding: viewsheds are computed in floats, whose step at 100 m is 8e-6 m, over
// lines of up to 100 cells: 1e-2 m where the line is flat. At most 1 of 6,887 posts differs; measured none.
TEST(NeededHeight, IsWhereTargetsBeginToBeSeen) {
  const HeightMap map = hilly_map();
  const ocl::Device device = ocl::Device::open();
  const HeightField field(device, post_grid(map), map.heights_m);
  const Viewshed viewshed(device);
  const CancelToken cancel;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> x(0.0, 2880.0), z(0.0, 1400.0);
  for (int i = 0; i < 12; ++i) {
    ViewshedParameters parameters{.observer_x_m = i == 0 ? 900.0 : x(random),
                                  .observer_z_m = i == 0 ? 400.0 : z(random),
                                  .observer_height_m = i < 6 ? 1.7 : 0.0,
                                  .curve = {i % 2 == 0 ? 30000.0 : EarthCurve{}.radius_m, 0.0}};
    const std::vector<float> needed_m = needed_heights(map, parameters, cancel);
    for (const double target_m : {0.0, 2.0, 25.0}) {
      parameters.target_height_m = target_m;
      ocl::Buffer<std::uint8_t> buffer(device, map.heights_m.size(), "seen");
      viewshed.at(field, parameters, buffer);
      const std::vector<std::uint8_t> seen = buffer.read();
      int wrong = 0, hidden = 0;
      for (std::size_t post = 0; post < seen.size(); ++post) {
        EXPECT_GE(needed_m[post], 0.0f);
        const bool is_near = std::abs(static_cast<double>(needed_m[post]) - target_m) < 1e-2;
        hidden += seen[post] == 0 ? 1 : 0;
        if (!is_near && (seen[post] == 255) != (static_cast<double>(needed_m[post]) < target_m)) ++wrong;
      }
      EXPECT_LE(wrong, 1) << i << ' ' << target_m;
      EXPECT_GT(hidden, target_m > 20.0 ? 0 : 500) << i;
    }
  }
}

// Behind a wall of 20 m, 100 m away from an eye 2 m up on level ground, a target at 300 m must be 2 + 3 (20 -
// 2) = 56 m high. Fails if the line is not straight, or the radius does nothing.
TEST(NeededHeight, IsOnTheLineOverAWall) {
  HeightMap map{.columns = 41,
                .rows = 5,
                .spacing_x_m = 10.0,
                .spacing_z_m = 10.0,
                .heights_m = {},
                .is_void = {},
                .georeference = {}};
  map.heights_m.assign(205, 0.0f);
  for (int row = 0; row < 5; ++row) map.heights_m[map.index(10, row)] = 20.0f;
  const CancelToken cancel;
  const std::vector<float> needed_m = needed_heights(
      map, {.observer_x_m = 0.0, .observer_z_m = 20.0, .observer_height_m = 2.0, .radius_m = 350.0}, cancel);
  EXPECT_NEAR(needed_m[map.index(30, 2)], 56.0, 1e-5);
  EXPECT_NEAR(needed_m[map.index(20, 2)], 38.0, 1e-5);
  EXPECT_EQ(needed_m[map.index(10, 2)], 0.0f);
  EXPECT_EQ(needed_m[map.index(5, 2)], 0.0f);
  EXPECT_EQ(needed_m[map.index(0, 2)], 0.0f);
  EXPECT_TRUE(std::isnan(needed_m[map.index(36, 2)]));
}

}  // namespace
}  // namespace offing::terrain
