#include "present/panels/mini_map.h"

#include <cmath>

#include <gtest/gtest.h>

namespace offing::present {
namespace {

HeightMap cone() {
  HeightMap map;
  map.columns = map.rows = 65;
  map.spacing_x_m = map.spacing_z_m = 10.0;
  for (int row = 0; row < 65; ++row) {
    for (int column = 0; column < 65; ++column)
      map.heights_m.push_back(static_cast<float>(300.0 - 8.0 * std::hypot(column - 32, row - 32)));
  }
  return map;
}

// Fails if the map is turned over or lit from elsewhere: of a cone, what faces north-west is bright, what
// faces south-east is dark, and the top is whiter than the foot.
TEST(MiniMapTest, IsLitFromTheNorthWest) {
  constexpr int side = 64;
  const std::vector<unsigned char> pixels = MiniMap::shaded(cone(), {}, side, side);
  ASSERT_EQ(pixels.size(), 3u * side * side);
  const auto brightness = [&](int column, int row) {
    const auto at = static_cast<std::size_t>(3 * (row * side + column));
    return pixels[at] + pixels[at + 1] + pixels[at + 2];
  };
  EXPECT_GT(brightness(20, 20), 1.5 * brightness(44, 44));
  EXPECT_NEAR(brightness(20, 44), brightness(44, 20), 40);
}

// Fails if the map paints the sea as land, or land as the sea: of a cone in water up to half its height the
// foot is blue, and land is green from the shore on.
TEST(MiniMapTest, ShowsTheSeaInBlue) {
  constexpr int side = 64;
  const auto is_blue = [&](const std::vector<unsigned char>& pixels, int column) {
    const auto at = static_cast<std::size_t>(3 * (side / 2 * side + column));
    return pixels[at + 2] > pixels[at] && pixels[at + 2] > pixels[at + 1];
  };
  const std::vector<unsigned char> dry = MiniMap::shaded(cone(), {}, side, side),
                                   wet = MiniMap::shaded(cone(), 150.0, side, side);
  EXPECT_FALSE(is_blue(dry, 3));
  EXPECT_TRUE(is_blue(wet, 3));
  // The cone is 150 m high some 19 posts from its middle.
  EXPECT_TRUE(is_blue(wet, 11));
  EXPECT_FALSE(is_blue(wet, 16));
  EXPECT_GT(wet[3 * (32 * side + 16) + 1], wet[3 * (32 * side + 16) + 2]);
}

}  // namespace
}  // namespace offing::present
