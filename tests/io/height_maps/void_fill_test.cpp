#include "host/io/height_maps/void_fill.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace offing::height_maps {
namespace {

// Fails if a known height changes, a void is left, or a filled one leaves the range of the known: for sizes
// that are powers of two and not, with one known post up to all but one.
TEST(VoidFill, StaysWithinTheKnownHeights) {
  std::mt19937 random(3);
  for (const auto& [columns, rows] : {std::pair{2, 2}, {7, 3}, {16, 16}, {33, 65}}) {
    const std::size_t posts = static_cast<std::size_t>(columns * rows);
    for (const double void_share : {0.1, 0.5, 0.95}) {
      std::vector<float> heights_m(posts);
      std::vector<std::uint8_t> is_void(posts);
      for (std::size_t i = 0; i < posts; ++i) {
        is_void[i] = std::uniform_real_distribution<>()(random) < void_share ? 1 : 0;
        heights_m[i] =
            is_void[i] != 0 ? -32768.0f : std::uniform_real_distribution<float>(200.0f, 900.0f)(random);
      }
      is_void[0] = 0;
      heights_m[0] = 500.0f;
      const std::vector<float> before = heights_m;
      fill_voids(columns, rows, heights_m, is_void);
      for (std::size_t i = 0; i < posts; ++i) {
        if (is_void[i] == 0) {
          ASSERT_EQ(heights_m[i], before[i]);
        }
        ASSERT_GE(heights_m[i], 199.99f);
        ASSERT_LE(heights_m[i], 900.01f);
      }
    }
  }
}

// Fails if a wide void keeps a cliff at its rim: on a slope of 1 m a post with a void of 32 x 32, no filled
// post may differ from its neighbour outside by more than a quarter of the void's width (a plateau at the
// mean would by 16). Measured: see the gate, which is half of that plateau's step.
TEST(VoidFill, MeetsTheRim) {
  constexpr int side = 96;
  std::vector<float> heights_m;
  std::vector<std::uint8_t> is_void;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      heights_m.push_back(static_cast<float>(column));
      is_void.push_back(column >= 32 && column < 64 && row >= 32 && row < 64 ? 1 : 0);
    }
  }
  fill_voids(side, side, heights_m, is_void);
  float worst_m = 0.0f;
  for (int row = 32; row < 64; ++row) {
    worst_m = std::max({worst_m, std::abs(heights_m[static_cast<std::size_t>(row * side + 32)] - 31.0f),
                        std::abs(heights_m[static_cast<std::size_t>(row * side + 63)] - 64.0f)});
  }
  EXPECT_LE(worst_m, 8.0f);
}

}  // namespace
}  // namespace offing::height_maps
