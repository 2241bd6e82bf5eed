// What covers the ground near the eye: how much detail it shows, and how much of that is aliasing, against
// pictures of eight times as many pixels a side.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/terrain/aliasing.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Sampling;
using terrain::Texel;

constexpr int finer = 8, wide_px = 96, high_px = 54;

/// Ground that slopes up to the south and is of one kind.
struct Ground {
  const char* name;
  double slope;
  float beach_line_m, tree_line_m, snow_line_m;
  double once;  ///< gradient energy over the mean light's square, of the value noise that was here before
};

/// Pixels of a picture of 640 x 360 at 60 degrees, 1.7 m over the ground, where its lowest third is.
Camera on_foot(double ground_m, double yaw_rad) {
  return {.eye_m = {400.0, ground_m + 1.7, 400.0},
          .yaw_rad = yaw_rad,
          .pitch_rad = -18.0 / 180.0 * std::numbers::pi,
          .vertical_field_of_view_rad = 9.0 / 180.0 * std::numbers::pi,
          .width_px = wide_px,
          .height_px = high_px};
}

std::vector<double> luminances(const std::vector<Texel>& image) {
  std::vector<double> found;
  for (const Texel& texel : image) found.push_back(static_cast<double>(texel[1]));
  return found;
}

double mean_of(const std::vector<double>& image) {
  return std::accumulate(image.begin(), image.end(), 0.0) / static_cast<double>(image.size());
}

double gradient_energy(const std::vector<double>& image) {
  return test::gradient_energy(image, wide_px);
}

/// Gradient energy of a picture over the mean light's square, and aliasing: that of the difference from the
/// mean of 64 pixels, over that of the picture.
struct Detail {
  double energy, aliasing;
};

Detail detail_of(test::TerrainPainter& painter, Camera camera) {
  const std::vector<double> found = luminances(painter.draw(camera, {}));
  camera.width_px *= finer;
  camera.height_px *= finer;
  const std::vector<double> fine = luminances(painter.draw(camera, {.sampling = {.rays = 1}}));
  const double energy = gradient_energy(found), light = mean_of(found);
  return {energy / (light * light), test::aliasing(found, fine, wide_px, finer)};
}

/// A hillside of one kind of ground that slopes up to the south.
test::HeightMap hillside(double slope) {
  test::HeightMap map{"hillside", {.columns = 65, .rows = 65, .spacing_x_m = 12.5, .spacing_z_m = 12.5}, {}};
  for (int row = 0; row < 65; ++row) {
    map.heights_m.insert(map.heights_m.end(), 65, static_cast<float>(12.5 * slope * row));
  }
  return map;
}

// Octaves as large as a pixel leave 14 % unexplained, those twice as large 1 %: bound 0.1 where all have the
// same strength. Found 0.011 ... 0.082; limit 0.1. Detail: found 11 to 31 times that of before, of snow 14
// times; limit 5. The noise of before had an aliasing of 0.2 and so fails both. Fails if ground near the eye
// is a blur, or if its detail is not that of the ground.
TEST(TerrainReliefTest, GroundNearTheEyeHasDetailWithoutAliasing) {
  constexpr float far_m = 1e5f;
  const std::vector<Ground> grounds = {{"meadow", 0.1, -far_m, far_m, far_m, 0.0082},
                                       {"scree", 0.3, -far_m, -far_m, far_m, 0.0063},
                                       {"rock", 1.2, -far_m, -far_m, far_m, 0.0104},
                                       {"sand", 0.05, far_m, far_m, far_m, 0.0066},
                                       {"snow", 0.1, -far_m, -far_m, -far_m, 0.0002}};
  for (const Ground& ground : grounds) {
    const test::HeightMap map = hillside(ground.slope);
    test::PaintedTerrain scene = test::PaintedTerrain::covered(map);
    scene.light.sea_level_m = -far_m;
    scene.light.beach_line_m = ground.beach_line_m;
    scene.light.tree_line_m = ground.tree_line_m;
    scene.light.snow_line_m = ground.snow_line_m;
    test::TerrainPainter painter(map, scene);
    const Detail detail = detail_of(painter, on_foot(400.0 * ground.slope, 0.5 * std::numbers::pi));
    std::printf("%-6s detail %.4f, once %.4f; aliasing %.3f\n", ground.name, detail.energy, ground.once,
                detail.aliasing);
    EXPECT_GE(detail.energy, 5.0 * ground.once) << ground.name;
    EXPECT_LE(detail.aliasing, 0.1) << ground.name;
  }
}

/// Of an image of so many columns, those at its left edge.
std::vector<double> left_part(const std::vector<double>& image, int columns, int part) {
  std::vector<double> left;
  for (auto row = image.begin(); row != image.end(); row += columns) left.insert(left.end(), row, row + part);
  return left;
}

// Aliasing as above, at the left edge of a picture that is 92 degrees wide, where pixels are narrower by a
// half and lower by 0.7: found 0.058 on a meadow, limit 0.1. Fails where pixels there show the mean of as
// much ground as those in the middle: 0.20.
TEST(TerrainReliefTest, EdgesOfPicturesAreSharp) {
  const test::HeightMap map = hillside(0.4);
  test::PaintedTerrain scene = test::PaintedTerrain::covered(map);
  constexpr float far_m = 1e5f;
  scene.light.sea_level_m = scene.light.beach_line_m = -far_m;
  scene.light.tree_line_m = scene.light.snow_line_m = far_m;
  test::TerrainPainter painter(map, scene);
  Camera camera = on_foot(160.0, 0.75 * std::numbers::pi);
  constexpr int columns = 720;
  camera.width_px = columns;
  const std::vector<double> found = left_part(luminances(painter.draw(camera, {})), columns, wide_px);
  camera.width_px *= finer;
  camera.height_px *= finer;
  const std::vector<double> fine = left_part(luminances(painter.draw(camera, {.sampling = {.rays = 1}})),
                                             columns * finer, wide_px * finer);
  const double aliasing = test::aliasing(found, fine, wide_px, finer);
  std::printf("edge of a meadow: aliasing %.3f\n", aliasing);
  EXPECT_LE(aliasing, 0.1);
}

test::PaintedTerrain low_ground(const test::HeightMap& map, float beach_line_m) {
  test::PaintedTerrain scene = test::PaintedTerrain::covered(map);
  scene.light.beach_line_m = beach_line_m;
  scene.light.sea_level_m = -1e5f;
  scene.light.tree_line_m = scene.light.snow_line_m = 1e5f;
  return scene;
}

// Tufts of grass, dead stalks, flowers and soil between tufts differ in colour. The deviation of red over
// green from pixel to pixel, over its mean: 0.044 of the even noise that was here before, found 0.069; limit
// 0.055. Fails if a meadow near the eye is of one colour, as fur is.
TEST(TerrainReliefTest, MeadowsNearTheEyeHaveColours) {
  const test::HeightMap map = hillside(0.1);
  test::TerrainPainter painter(map, low_ground(map, -1e5f));
  const std::vector<Texel> image = painter.draw(on_foot(40.0, 0.5 * std::numbers::pi), {});
  double sum = 0.0, squares = 0.0;
  for (const Texel& texel : image) {
    const double ratio = static_cast<double>(texel[0]) / static_cast<double>(texel[1]);
    sum += ratio;
    squares += ratio * ratio;
  }
  const auto pixels = static_cast<double>(image.size());
  const double deviation = std::sqrt(squares / pixels / std::pow(sum / pixels, 2) - 1.0);
  std::printf("red over green of a meadow: %.4f\n", deviation);
  EXPECT_GE(deviation, 0.055);
}

// Without the sun, ground is lit by the sky alone. Gradient energy over the mean light's square: 0.0068
// where all slopes got the same of it, found 0.034; limit 0.02. Fails if sand in the shade is flat.
TEST(TerrainReliefTest, ShadedSandShowsItsRelief) {
  const test::HeightMap map = hillside(0.05);
  test::PaintedTerrain scene = low_ground(map, 1e5f);
  scene.light.sun_red_klx = scene.light.sun_green_klx = scene.light.sun_blue_klx = 0.0f;
  test::TerrainPainter painter(map, scene);
  const std::vector<double> found = luminances(painter.draw(on_foot(20.0, 0.5 * std::numbers::pi), {}));
  const double light = mean_of(found), detail = gradient_energy(found) / (light * light);
  std::printf("sand in the shade: detail %.4f\n", detail);
  EXPECT_GE(detail, 0.02);
}

// A meadow uphill, 8 to 70 m away: tufts and flowers become smaller than pixels. Aliasing as above: found
// 0.075, limit 0.1. Fails where they end at once where pixels are 0.6 of a tuft: 0.155.
TEST(TerrainReliefTest, TuftsAndFlowersFadeWithTheDistance) {
  const test::HeightMap map = hillside(0.5);
  test::TerrainPainter painter(map, low_ground(map, -1e5f));
  Camera camera = on_foot(200.0, std::numbers::pi);
  camera.pitch_rad = 21.0 / 180.0 * std::numbers::pi;
  const double aliasing = detail_of(painter, camera).aliasing;
  std::printf("meadow uphill: aliasing %.3f\n", aliasing);
  EXPECT_LE(aliasing, 0.1);
}

// A meadow where pixels are about as wide as blades of grass, or narrower, but up to ten times as long: from
// 2 to 4 m and, in a picture as fine as one of 6,000 columns, about 20 m away. Aliasing as above: found 0.034
// and 0.046, limit 0.052. Fails where pixels show as little of blades that point to the eye as of those that
// lie across, 0.084 and 0.070, or show those of one place of their footprint alone, 0.058 far away.
TEST(TerrainReliefTest, BladesOfGrassShowThatPointToTheEye) {
  struct View {
    double pitch_deg, field_of_view_deg;
  };
  const test::HeightMap map = hillside(0.1);
  test::TerrainPainter painter(map, low_ground(map, -1e5f));
  for (const View& view : {View{-33.0, 9.0}, View{-5.0, 1.0}}) {
    Camera camera = on_foot(40.0, 0.5 * std::numbers::pi);
    camera.pitch_rad = view.pitch_deg / 180.0 * std::numbers::pi;
    camera.vertical_field_of_view_rad = view.field_of_view_deg / 180.0 * std::numbers::pi;
    const double aliasing = detail_of(painter, camera).aliasing;
    std::printf("blades: aliasing %.3f\n", aliasing);
    EXPECT_LE(aliasing, 0.052) << view.pitch_deg;
  }
}

/// Straight down from so far above the ground, which is level from left to right.
Camera from_above(double south_m, double ground_m, double above_m) {
  return {.eye_m = {400.0, ground_m + above_m, south_m},
          .yaw_rad = 0.0,
          .pitch_rad = -0.499 * std::numbers::pi,
          .vertical_field_of_view_rad = 0.4,
          .width_px = 320,
          .height_px = 320};
}

// A meadow near the eye, and 600 m of it from above. Without detail finer than the largest cells of the noise
// of materials, 64 m, none of the gradient energy is left, limit 0.01; without detail finer than a metre
// 0.002 of it, limit 0.01. The mean light from above stays, found within 0.0025; limit 0.01. Fails if the
// setting does nothing, leaves tufts, or makes the ground darker or brighter.
TEST(TerrainReliefTest, GroundWithoutFineDetailIsItsMean) {
  const test::HeightMap map = hillside(0.1);
  test::TerrainPainter painter(map, low_ground(map, -1e5f));
  const auto light_of = [&](const Camera& camera, double finest_m) {
    return luminances(painter.draw(camera, {.finest_detail_m = finest_m}));
  };
  const Camera near = on_foot(40.0, 0.5 * std::numbers::pi), above = from_above(400.0, 40.0, 1500.0);
  const double whole = gradient_energy(light_of(near, 0.0)), light = mean_of(light_of(above, 0.0));
  for (const double finest_m : {120.0, 1.0}) {
    const double left = gradient_energy(light_of(near, finest_m)) / whole;
    const double brighter = mean_of(light_of(above, finest_m)) / light - 1.0;
    std::printf("finest %.0f m: %.4f of the gradient energy, %.4f brighter\n", finest_m, left, brighter);
    EXPECT_LE(left, 0.01) << finest_m;
    EXPECT_NEAR(brighter, 0.0, 0.01) << finest_m;
  }
}

// Flowers from 3 m above, of six pixels each: those pixels that are almost as red as the reddest, and those
// half as red, of edges. Found 1.6 of these for one of those; limit 2.5. Fails where flowers are blurred
// discs: 4.1.
TEST(TerrainReliefTest, FlowersNearTheEyeHaveEdges) {
  const test::HeightMap map = hillside(0.1);
  test::TerrainPainter painter(map, low_ground(map, -1e5f));
  std::vector<float> red;
  for (double south_m = 390.0; south_m < 410.0; south_m += 4.0) {
    for (const Texel& texel : painter.draw(from_above(south_m, 0.1 * south_m, 3.0), {}))
      red.push_back(texel[0]);
  }
  std::sort(red.begin(), red.end());
  const float most = red[red.size() - red.size() / 20000];
  std::size_t whole = 0, half = 0;
  for (const float value : red) {
    whole += value > 0.7f * most ? 1 : 0;
    half += value > 0.4f * most && value <= 0.7f * most ? 1 : 0;
  }
  const double edges = static_cast<double>(half) / static_cast<double>(whole);
  std::printf("flowers: %zu pixels whole, %.2f as many half\n", whole, edges);
  EXPECT_GT(whole, red.size() / 5000);
  EXPECT_LE(edges, 2.5);
}

// The highest waves of a tide leave weed at 1.5 times the reach of the swash and 5 cm. Mean light there, over
// that where the sand begins to dry, 1.2 times the reach: found 0.71, limit 0.9. Fails where the weed
// lies beside the damp sand: 1.47.
TEST(TerrainReliefTest, WeedLiesWhereTheHighestWavesLeftIt) {
  const test::HeightMap map = hillside(0.1);
  test::PaintedTerrain scene = low_ground(map, 1e5f);
  scene.light.swash.reach_m = 0.4f;
  scene.light.swash.period_s = 6.0f;
  scene.light.still_water_m = 40.0f;
  test::TerrainPainter painter(map, scene);
  const auto light_at = [&](double height_m) {
    double sum = 0.0;
    const std::vector<double> light =
        luminances(painter.draw(from_above(10.0 * height_m, height_m, 3.0), {}));
    for (const double value : light) sum += value / static_cast<double>(light.size());
    return sum;
  };
  const double share = light_at(40.65) / light_at(40.53);
  std::printf("weed: %.3f of the light below it\n", share);
  EXPECT_LE(share, 0.9);
}

// Wet sand in the shade, 60 m away aslant, where a pixel is higher than the band that mirrors the sky.
// Aliasing as above: found 0.031, limit 0.1. Fails where pixels show the film at their middles: 0.167.
TEST(TerrainReliefTest, WetSandFarAwayHasNoStairs) {
  const test::HeightMap map = hillside(0.05);
  test::PaintedTerrain scene = low_ground(map, 1e5f);
  scene.light.sun_red_klx = scene.light.sun_green_klx = scene.light.sun_blue_klx = 0.0f;
  scene.light.swash.reach_m = 0.15f;
  scene.light.swash.period_s = 6.0f;
  scene.light.still_water_m = 17.0f;
  test::TerrainPainter painter(map, scene);
  Camera camera = on_foot(20.0, 0.1 * std::numbers::pi);
  camera.pitch_rad = -4.5 / 180.0 * std::numbers::pi;
  const double aliasing = detail_of(painter, camera).aliasing;
  std::printf("wet sand far away: aliasing %.3f\n", aliasing);
  EXPECT_LE(aliasing, 0.1);
}

}  // namespace
}  // namespace offing
