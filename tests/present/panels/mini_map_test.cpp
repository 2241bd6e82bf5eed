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
  const std::vector<unsigned char> pixels = MiniMap::shaded(cone(), side, side);
  ASSERT_EQ(pixels.size(), 3u * side * side);
  const auto brightness = [&](int column, int row) {
    const auto at = static_cast<std::size_t>(3 * (row * side + column));
    return pixels[at] + pixels[at + 1] + pixels[at + 2];
  };
  EXPECT_GT(brightness(20, 20), 1.5 * brightness(44, 44));
  EXPECT_NEAR(brightness(20, 44), brightness(44, 20), 40);
}

}  // namespace
}  // namespace offing::present
