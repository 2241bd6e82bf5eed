#include "host/terrain/generate/fractal_terrain.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "host/terrain/generate/gullies.h"
#include "tests/ocl/expect_error.h"

namespace offing {
namespace {

using terrain::FractalParameters;
using terrain::FractalTerrain;

std::vector<float> heights_of(const FractalParameters& parameters) {
  FractalTerrain terrain(parameters);
  const auto posts = static_cast<std::size_t>(parameters.posts);
  std::vector<float> heights_m(posts * posts);
  for (std::size_t row = 0; row < posts; ++row) {
    terrain.fill_row(static_cast<int>(row), std::span(heights_m).subspan(row * posts, posts));
  }
  return heights_m;
}

// Fails if rows depend on those asked for before.
TEST(FractalTerrainTest, RowsComeInAnyOrder) {
  const FractalParameters parameters{.posts = 129, .erosion = 0.5, .seed = 5};
  const std::vector<float> expected = heights_of(parameters);
  FractalTerrain terrain(parameters);
  std::vector<float> row_m(129);
  for (const int row : {100, 3, 4, 128, 0, 64}) {
    terrain.fill_row(row, row_m);
    EXPECT_TRUE(std::equal(row_m.begin(), row_m.end(), expected.begin() + 129 * row)) << row;
  }
}

// An island is the same ground, sunk by nothing in its middle and by the relief from its radius on.
TEST(FractalTerrainTest, AnIslandSinksTowardItsShore) {
  const FractalParameters terrain{.posts = 65, .side_m = 6400.0, .relief_m = 500.0, .longest_m = 3000.0};
  FractalParameters island = terrain;
  island.island_radius_m = 2000.0;
  const std::vector<float> before = heights_of(terrain), sunk = heights_of(island);
  const auto sinking_m = [&](std::size_t row, std::size_t column) {
    return double{before[row * 65 + column]} - double{sunk[row * 65 + column]};
  };
  constexpr double rounding_m = 1e-3;
  EXPECT_NEAR(sinking_m(32, 32), 0.0, rounding_m);
  EXPECT_NEAR(sinking_m(32, 42), 375.0, rounding_m);  // at half the radius
  EXPECT_NEAR(sinking_m(32, 52), 500.0, rounding_m);
  EXPECT_NEAR(sinking_m(0, 0), 500.0, rounding_m);
}

// The same ground with more posts differs by the octave that it adds, the sixth: 937 m / 2^5 times gradient
// noise, whose largest value is the root of 1/2: 20.7 m. Measured 18.2 m.
TEST(FractalTerrainTest, MorePostsShowTheSameGround) {
  const std::vector<float> coarse = heights_of({.posts = 129}), fine = heights_of({.posts = 257});
  double worst_m = 0.0;
  for (std::size_t row = 0; row < 129; ++row) {
    for (std::size_t column = 0; column < 129; ++column) {
      worst_m =
          std::max<double>(worst_m, std::abs(coarse[row * 129 + column] - fine[2 * row * 257 + 2 * column]));
    }
  }
  EXPECT_GT(worst_m, 0.0);
  EXPECT_LT(worst_m, 20.8);
}

// Fails, under a sanitizer at the latest, if the last post has no lattice where its place rounds to beyond
// the side: 199 * (1000 / 199) = 1000.0000000000001, which is 15 of the longest wavelengths and not less.
TEST(FractalTerrainTest, LastPostsHaveALattice) {
  const FractalParameters parameters{
      .posts = 200, .side_m = 1000.0, .longest_m = 66.66666666666667, .erosion = 0.5};
  for (const float height_m : heights_of(parameters)) {
    ASSERT_LE(std::abs(height_m - static_cast<float>(parameters.mean_m)), parameters.relief_m);
  }
}

// About the relief that was asked for: within a factor of 2.
TEST(FractalTerrainTest, HasTheReliefThatIsAsked) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const std::vector<float> heights_m = heights_of({.posts = 257, .side_m = 40'000.0, .seed = seed});
    const auto [low, high] = std::minmax_element(heights_m.begin(), heights_m.end());
    EXPECT_GT(*high - *low, 750.0f) << seed;
    EXPECT_LT(*high - *low, 3000.0f) << seed;
  }
}

// Fails if the middle is not where it is asked: within half the relief.
TEST(FractalTerrainTest, HasTheMiddleThatIsAsked) {
  const std::vector<float> low = heights_of({.posts = 129, .mean_m = -500.0}),
                           high = heights_of({.posts = 129, .mean_m = 1000.0});
  for (std::size_t i = 0; i < low.size(); ++i) EXPECT_NEAR(high[i] - low[i], 1500.0f, 1e-3f);
  double sum_m = 0.0;
  for (const float height_m : high) sum_m += height_m;
  EXPECT_NEAR(sum_m / static_cast<double>(high.size()), 1000.0, 750.0);
}

// Fails if gullies lift the ground, cut deeper than their depths together (0.3 of widths 810 m, 405 m, ...:
// 486 m), or cut no slopes.
TEST(FractalTerrainTest, ErosionCutsGullies) {
  FractalParameters parameters{.posts = 513, .erosion = 1.0};
  const std::vector<float> cut = heights_of(parameters);
  parameters.erosion = 0.0;
  const std::vector<float> uncut = heights_of(parameters);
  double deepest_m = 0.0, sum_m = 0.0;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    EXPECT_LE(cut[i], uncut[i]);
    deepest_m = std::max<double>(deepest_m, uncut[i] - cut[i]);
    sum_m += uncut[i] - cut[i];
  }
  EXPECT_LT(deepest_m, 486.0);
  EXPECT_GT(deepest_m, 30.0);
  EXPECT_GT(sum_m / static_cast<double>(cut.size()), 2.0);
}

// Fails if gullies do not run downhill: in a plane that falls to the east, the ground varies along z and not
// along x, but where spots of waves meet.
TEST(FractalTerrainTest, GulliesRunDownhill) {
  terrain::Gullies gullies(100.0, 0.3, 10'000.0, 3, 0);
  double along_m = 0.0, across_m = 0.0;
  for (double z_m = 0.0; z_m < 2000.0; z_m += 10.0) {
    gullies.move_to(z_m);
    for (double x_m = 0.0; x_m < 2000.0; x_m += 10.0) {
      const double here_m = gullies.at(x_m, z_m, -0.5, 0.0).height_m;
      along_m += std::abs(gullies.at(x_m + 10.0, z_m, -0.5, 0.0).height_m - here_m);
      gullies.move_to(z_m + 10.0);
      across_m += std::abs(gullies.at(x_m, z_m + 10.0, -0.5, 0.0).height_m - here_m);
      gullies.move_to(z_m);
    }
  }
  // Measured 5.7.
  EXPECT_GT(across_m, 3.0 * along_m);
  EXPECT_EQ(gullies.at(500.0, 500.0, 0.0, 0.0).height_m, 0.0);
}

TEST(FractalTerrainTest, SeedsDiffer) {
  EXPECT_NE(heights_of({.posts = 33, .seed = 1}), heights_of({.posts = 33, .seed = 2}));
}

TEST(FractalTerrainTest, RefusesWhatIsOutOfRange) {
  test::expect_error(ErrorKind::bad_input, "posts", [] { FractalTerrain({.posts = 1}); });
  test::expect_error(ErrorKind::bad_input, "side_m", [] { FractalTerrain({.side_m = 0.0}); });
  test::expect_error(ErrorKind::bad_input, "relief_m", [] { FractalTerrain({.relief_m = std::nan("")}); });
  test::expect_error(ErrorKind::bad_input, "longest_m", [] { FractalTerrain({.longest_m = 1.0}); });
  test::expect_error(ErrorKind::bad_input, "erosion", [] { FractalTerrain({.erosion = -0.1}); });
  test::expect_error(ErrorKind::bad_input, "mean_m", [] { FractalTerrain({.mean_m = std::nan("")}); });
  test::expect_error(ErrorKind::bad_input, "roughness", [] { FractalTerrain({.roughness = 1.0}); });
}

}  // namespace
}  // namespace offing
