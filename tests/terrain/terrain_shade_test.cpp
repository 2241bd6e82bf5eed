// Light on ground whose colour is known, that of water, against formulas in double precision.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Texel;

using std::numbers::pi;
constexpr double water_red = 0.042;  // of kernels/terrain/cover/terrain_cover.clh
constexpr std::size_t columns_px = 41, rows_px = 33;

/// A picture straight down from 80 m above the middle of a map under water, one ray a pixel.
struct Scene : test::PaintedTerrain {
  Camera camera{.eye_m = {64.0, 80.0, 64.0},
                .pitch_rad = -0.5 * pi,
                .vertical_field_of_view_rad = 0.9,
                .width_px = columns_px,
                .height_px = rows_px};

  std::vector<Texel> draw(const std::function<double(int, int)>& height_m,
                          const terrain::SeaOverTerrain& sea = {}) const {
    test::HeightMap map{.name = "made",
                        .grid = {.columns = 65, .rows = 65, .spacing_x_m = 2.0, .spacing_z_m = 2.0},
                        .heights_m = {}};
    for (int row = 0; row < map.grid.rows; ++row) {
      for (int column = 0; column < map.grid.columns; ++column) {
        map.heights_m.push_back(static_cast<float>(height_m(column, row)));
      }
    }
    return test::TerrainPainter(map, *this).draw(camera, {.sampling = {.rays = 1}, .sea = sea});
  }
};

/// Red light that water sends up, of which the sun lights a share; `to_sun` and `up` are cosines of its
/// normal.
double water_light(double to_sun, double up, double level_sun, double sun_share) {
  const double sky_share = 0.5 + 0.5 * up;
  const double bounced = water_red * (1.0 - sky_share) * (100.0 * level_sun + 10.0);
  return water_red / pi * (100.0 * to_sun * sun_share + 10.0 * sky_share + bounced);
}

// Floats: gate 1e-5 of the light. Fails if a normal, the share of sky or the sun's angle is wrong, or if the
// ground shades itself where it faces the sun.
TEST(TerrainShadeTest, LightsSlopesByTheirAngle) {
  const Scene scene;
  const double level_sun = std::sin(scene.sun_elevation_rad);
  for (const double slope : {0.0, 0.3, -0.3}) {
    const std::vector<Texel> image = scene.draw([&](int column, int) { return slope * 2.0 * (column - 32); });
    const double up = 1.0 / std::hypot(1.0, slope);
    const double to_sun = (level_sun - slope * std::cos(scene.sun_elevation_rad)) * up;
    const double expected = water_light(to_sun, up, level_sun, 1.0);
    for (const Texel& texel : image) {
      ASSERT_NEAR(texel[0], expected, 1e-5 * expected) << "slope " << slope;
      ASSERT_EQ(texel[3], 1.0f);
    }
  }
}

// West of a wall of 20 m the sun's disc, 11 degrees wide here, goes down behind its edge: pixels know how
// much of the disc is above it. The area above a level line is (a - sin a cos a) / pi; the cubic is 0.03 off,
// the rest is the lift of shadows' origins and the disc's edges, which the fan takes as straight up; gate
// 0.06. Fails if shadows are hard, misplaced or of another width.
TEST(TerrainShadeTest, CutsTheSunsDiscAtTheHorizon) {
  Scene scene;
  scene.sun_radius_rad = 0.1;
  const double wall_m = 20.0, wall_x_m = 84.0;
  const std::vector<Texel> image =
      scene.draw([&](int column, int) { return 2.0 * column >= wall_x_m ? wall_m : 0.0; });
  const double level_sun = std::sin(scene.sun_elevation_rad), dark = water_light(0.0, 1.0, level_sun, 0.0);
  int partly = 0;
  for (std::size_t column = 0; column < columns_px; ++column) {
    // The middle row, whose rays stay in the plane of the sun.
    const double clip = (static_cast<double>(column) + 0.5) * 2.0 / columns_px - 1.0;
    const double x_m = 64.0 + 80.0 * std::tan(0.45) * columns_px / rows_px * clip;
    if (x_m > wall_x_m - 6.0) continue;  // slopes there are averaged with the wall's
    const double edge_rad = std::atan2(wall_m, wall_x_m - x_m);
    const double above = std::clamp((scene.sun_elevation_rad - edge_rad) / scene.sun_radius_rad, -1.0, 1.0);
    const double angle = std::acos(-above);
    const double share = (angle - std::sin(angle) * std::cos(angle)) / pi;
    const double found = (image[rows_px / 2 * columns_px + column][0] - dark) /
                         (water_light(level_sun, 1.0, level_sun, 1.0) - dark);
    EXPECT_NEAR(found, share, 0.06) << "column " << column << ", " << x_m << " m";
    partly += share > 0.1 && share < 0.9 ? 1 : 0;
  }
  EXPECT_GE(partly, 2) << "the penumbra is not in the picture";
}

// Through air of an optical depth the ground fades into the sky. Gate 1e-5.
TEST(TerrainShadeTest, AirTakesAndAddsLight) {
  Scene scene;
  scene.light.aerosol_perm = 0.004f;
  const double level_sun = std::sin(scene.sun_elevation_rad);
  const Texel middle = scene.draw([](int, int) { return 0.0; })[rows_px / 2 * columns_px + columns_px / 2];
  // Straight down from 80 m through air that thins by e in 1200 m.
  const double left = std::exp(-0.004 * 1200.0 * (1.0 - std::exp(-80.0 / 1200.0)));
  const double expected =
      water_light(level_sun, 1.0, level_sun, 1.0) * left + scene.haze_kcdpm2 * (1.0 - left);
  EXPECT_NEAR(middle[0], expected, 1e-5 * expected);
}

// Nothing is drawn where nothing is hit: the sky is not the ground's to draw.
TEST(TerrainShadeTest, LeavesTheSkyAlone) {
  Scene scene;
  scene.camera.pitch_rad = 0.5 * pi;
  for (const Texel& texel : scene.draw([](int, int) { return 0.0; })) EXPECT_EQ(texel, (Texel{}));
}

/// Light reflected by water at a facet, by the sine of the ray's angle to it (Fresnel).
double water_mirrors(double sine) {
  const double index = 1.34, inside = std::sqrt(index * index - 1.0 + sine * sine);
  const double across = (sine - inside) / (sine + inside);
  const double along = (index * index * sine - inside) / (index * index * sine + inside);
  return 0.5 * (across * across + along * along);
}

// Deep water that nothing lights mirrors the same sky from all sides by Fresnel's share, on the map and
// beyond its edge, but for ripples of 0.3 degrees: gate 0.03. Fails if water is painted as ground, if what
// lies beyond the map is not the same water, or if it is there where no sea goes on.
TEST(TerrainShadeTest, WaterMirrorsTheSkyAndGoesOnBeyondTheMap) {
  Scene scene;
  scene.light.sun_red_klx = scene.light.sky_red_klx = 0.0f;
  scene.light.sea_level_m = 0.0f;
  scene.light.water_slopes = 3e-5f;
  scene.camera.eye_m = {64.0, 20.0, 64.0};
  scene.camera.pitch_rad = -0.25;
  scene.camera.vertical_field_of_view_rad = 0.7;
  const test::HeightMap map{.name = "bed",
                            .grid = {.columns = 65, .rows = 65, .spacing_x_m = 2.0, .spacing_z_m = 2.0},
                            .heights_m = std::vector<float>(std::size_t{65} * 65, -8.0f)};
  test::TerrainPainter painter(map, scene);
  const std::vector<Texel> with = painter.draw(scene.camera, {.sampling = {.rays = 1}, .sea_goes_on = true});
  const std::vector<Texel> without = painter.draw(scene.camera, {.sampling = {.rays = 1}});
  int beyond = 0, on_map = 0, sky = 0;
  for (std::size_t row = 0; row < rows_px; ++row) {
    for (std::size_t column = 0; column < columns_px; ++column) {
      const glm::dvec3 ray = glm::normalize(
          ray_direction(scene.camera, {(2.0 * static_cast<double>(column) + 1.0) / columns_px - 1.0,
                                       1.0 - (2.0 * static_cast<double>(row) + 1.0) / rows_px}));
      const Texel& texel = with[row * columns_px + column];
      const bool is_map = without[row * columns_px + column][3] == 1.0f;
      if (ray.y >= 0.0) {
        EXPECT_EQ(texel[3], 0.0f);
        ++sky;
        continue;
      }
      EXPECT_EQ(texel[3], 1.0f) << column << ' ' << row;
      EXPECT_NEAR(texel[0] / scene.haze_kcdpm2, water_mirrors(-ray.y), 0.03) << column << ' ' << row;
      ++(is_map ? on_map : beyond);
    }
  }
  EXPECT_GT(std::min({beyond, on_map, sky}), 99);
}

// A slope that rises by an eighth to the right. Fails if ground is drawn that lies deeper than asked or more
// than four pixels higher, if other ground is not, or if the depth does not grow with the square of the
// distance.
TEST(TerrainShadeTest, HidesWhatIsTooDeepOrTooHigh) {
  const Scene scene;
  constexpr double slope = 0.125, eye_m = 80.0, middle_x_m = 64.0;
  // Heights of rays are sums of floats of 80 m, some ten roundings of 4e-6 m; limits so near are left out.
  constexpr double rounding_m = 1e-3;
  const terrain::SeaOverTerrain sea{.below_m = 6.0, .bend_perm = 2e-4, .above_m = 1.0};
  const std::vector<Texel> image = scene.draw([](int column, int) { return slope * 2.0 * column; }, sea);
  const double pixel = 2.0 * std::tan(0.5 * scene.camera.vertical_field_of_view_rad) / rows_px;
  int shown = 0, deep = 0, high = 0;
  for (std::size_t row = 0; row < rows_px; ++row) {
    for (std::size_t column = 0; column < columns_px; ++column) {
      const double right = pixel * (static_cast<double>(column) + 0.5 - 0.5 * columns_px);
      const double up = pixel * (static_cast<double>(row) + 0.5 - 0.5 * rows_px);
      const double height_m = slope * (middle_x_m + eye_m * right) / (1.0 + slope * right);
      const double away_m = (eye_m - height_m) * std::hypot(1.0, right, up);
      const double deepest_m = sea.below_m - sea.bend_perm * away_m * away_m;
      // A pixel at the side is smaller, as it is farther away and seen aslant.
      const double cosine = 1.0 / std::hypot(1.0, right, up);
      const double highest_m = sea.above_m + 4.0 * pixel * away_m * cosine * std::sqrt(cosine);
      if (std::abs(height_m - deepest_m) < rounding_m || std::abs(height_m - highest_m) < rounding_m)
        continue;
      const bool is_deep = height_m < deepest_m;
      const bool is_high = height_m > highest_m;
      deep += is_deep ? 1 : 0;
      high += is_high ? 1 : 0;
      shown += is_deep || is_high ? 0 : 1;
      EXPECT_EQ(image[row * columns_px + column][3], is_deep || is_high ? 0.0f : 1.0f)
          << column << ' ' << row;
    }
  }
  EXPECT_GT(std::min({shown, deep, high}), 99);
}

// Posts of noise smaller than a pixel: its light is that of the mean slope, 0. Slopes between posts next to
// each other are 0.3 in the mean, which dims a sun overhead by 4 %; those over the 13 posts around a stride
// of the 16 posts of a pixel here are 0.03, and 0.07 at most, which dims it by 0.3 %. Gate 1 %.
TEST(TerrainShadeTest, AveragesSlopesThatAPixelDoesNotResolve) {
  Scene scene;
  scene.sun_elevation_rad = 1.5;
  scene.camera.eye_m.y = 132'000.0;
  scene.camera.vertical_field_of_view_rad = 0.008;
  const double level_sun = std::sin(scene.sun_elevation_rad);
  const std::vector<Texel> image =
      scene.draw([](int column, int row) { return 0.4 * ((column * 7919 + row * 104729) % 5); });
  const double expected = water_light(level_sun, 1.0, level_sun, 1.0);
  int terrain = 0;
  for (const Texel& texel : image) {
    if (texel[3] == 0.0f) continue;
    ++terrain;
    EXPECT_NEAR(texel[0], expected, 0.01 * expected);
  }
  EXPECT_GE(terrain, 9);
}

}  // namespace
}  // namespace offing
