// Edges of the ground and their stillness, against coverage by geometry and against many rays a pixel.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Sampling;
using terrain::Texel;

using std::numbers::pi;
constexpr Sampling one_ray{.rays = 1}, many_rays{.rays = 64, .least_contrast = -1.0};

/// Hills whose far side is finer than the pixels, seen against the sky from among them.
test::HeightMap hills() {
  return test::valleys({.columns = 400, .rows = 400, .spacing_x_m = 10.0, .spacing_z_m = 10.0});
}
Camera among_hills() {
  return {.eye_m = {2003.0, 95.0, 3903.0},
          .yaw_rad = 0.1,
          .pitch_rad = -0.04,
          .vertical_field_of_view_rad = 0.15,
          .width_px = 96,
          .height_px = 54};
}

// The west edge of a flat map, seen straight down and turned by 0.3 rad, cuts pixels: each one's coverage is
// its area on the map's side. 16 points, one in each column and row of 16, are as many as fall on one side of
// a line but for less than 2 (found: 1.2): gate 2/16 a pixel. Errors of up to 1.2/16 either way have a root
// mean square of 0.043, and their mean over n pixels of the edge one of 0.043 / sqrt(n): gate twice that.
// Fails if rays are not spread evenly over their own pixel, or if coverage is not their mean.
TEST(TerrainSamplingTest, CoversPixelsByTheirShareOfGround) {
  test::HeightMap map{"flat", {.columns = 65, .rows = 65, .spacing_x_m = 2.0, .spacing_z_m = 2.0}, {}};
  map.heights_m.assign(65 * 65, 0.0f);
  constexpr double height_m = 80.0, roll_rad = 0.3;
  constexpr int side_px = 41;
  const Camera camera{.eye_m = {0.3, height_m, 64.0},
                      .pitch_rad = -0.5 * pi,
                      .roll_rad = roll_rad,
                      .vertical_field_of_view_rad = 0.9,
                      .width_px = side_px,
                      .height_px = side_px};
  const std::vector<Texel> image = test::TerrainPainter(map, {}).draw(camera, {});
  const double pixel_m = 2.0 * height_m * std::tan(0.45) / side_px;
  double error_sum = 0.0;
  int edges = 0;
  for (int row = 0; row < side_px; ++row) {
    for (int column = 0; column < side_px; ++column) {
      // The share of 100 x 100 points of the pixel that are east of the edge.
      int inside = 0;
      for (int i = 0; i < 10'000; ++i) {
        const glm::dvec2 clip(2.0 * (column + (i % 100 + 0.5) / 100.0) / side_px - 1.0,
                              1.0 - 2.0 * (row + (i / 100 + 0.5) / 100.0) / side_px);
        const glm::dvec3 ray = ray_direction(camera, clip);
        inside += camera.eye_m.x - height_m * ray.x / ray.y >= 0.0 ? 1 : 0;
      }
      const double expected = inside / 1e4;
      const double found = image[static_cast<std::size_t>(row * side_px + column)][3];
      if (inside > 0 && inside < 10'000) {
        ++edges;
        error_sum += found - expected;
      }
      EXPECT_NEAR(found, expected, 2.0 / 16.0) << "row " << row << ", column " << column;
    }
  }
  EXPECT_GE(edges, side_px) << "of pixels of " << pixel_m << " m";
  std::printf("edge: %d pixels, mean error %.5f\n", edges, error_sum / edges);
  EXPECT_NEAR(error_sum / edges, 0.0, 2.0 * 0.043 / std::sqrt(edges));
}

// A pixel with one ray differs from its mean by half of what it differs from its neighbours at most, 0.1 of
// its light; one with 4 rays by 4^(-3/4) of half their contrast of 0.6, 0.11; one with 16 by 16^(-3/4) of
// half an edge, 0.06. Were all at their bounds the root mean square of 58 % with one ray and 42 % with more
// would be 0.103: gate 0.1 (found: 0.037; one ray 0.093). In the mean such errors cancel to 0.063 /
// sqrt(5184), but light of a mean slope, or of what covers it, is not the mean of light: gate 0.0098, which
// is what was found, 0.0071, and three deviations. Fails if refined pixels are brighter or darker than
// others, or if edges are missed.
TEST(TerrainSamplingTest, AgreesWithManyRaysAPixel) {
  const test::HeightMap map = hills();
  test::TerrainPainter painter(map, test::PaintedTerrain::covered(map));
  const std::vector<Texel> reference = painter.draw(among_hills(), {many_rays});
  const auto difference = [&](const Sampling& sampling, double& mean) {
    const std::vector<Texel> image = painter.draw(among_hills(), {sampling});
    double light = 0.0, sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i) {
      light += static_cast<double>(reference[i][1]);
      const double here = static_cast<double>(image[i][1]) - static_cast<double>(reference[i][1]);
      sum += here;
      squares += here * here;
    }
    const auto pixels = static_cast<double>(image.size());
    mean = sum / light;
    return std::sqrt(squares / pixels) / (light / pixels);
  };
  double mean = 0.0;
  const double of_one = difference(one_ray, mean), of_many = difference({}, mean);
  EXPECT_LE(of_many, 0.1);
  EXPECT_LE(of_many, 0.6 * of_one);
  std::printf("one ray %.4f, automatic %.4f, mean %.5f, refined %.3f\n", of_one, of_many, mean,
              painter.refined_share());
  EXPECT_NEAR(mean, 0.0, 0.0098);
  EXPECT_GT(painter.refined_share(), 0.1);
  EXPECT_LT(painter.refined_share(), 0.5);
}

// A pixel's light does not depend on the pixels that are drawn with it: those of a picture are those of the
// middle of a wider one, in which tiles and the vectors of rays begin elsewhere. Directions are rounded
// otherwise, to 1e-7 of the picture, so that a ray may pass an outline on the other side: gate 1 in 1,000
// pixels (found: none). Sides are no multiples of a tile's, nor numbers of rays of a vector's. Fails if light
// goes to another pixel, if a ray beyond the last counts, or if one is left out.
TEST(TerrainSamplingTest, LightsPixelsAloneAsAmongOthers) {
  const test::HeightMap map = hills();
  test::TerrainPainter painter(map, test::PaintedTerrain::covered(map));
  constexpr int aside_px = 5, above_px = 3;
  Camera camera = among_hills();
  camera.width_px = 93;
  camera.height_px = 51;
  Camera wider = camera;
  wider.width_px += 2 * aside_px;
  wider.height_px += 2 * above_px;
  wider.vertical_field_of_view_rad =
      2.0 * std::atan(std::tan(0.5 * camera.vertical_field_of_view_rad) * wider.height_px / camera.height_px);
  for (const int rays : {3, 5, 17}) {
    const Sampling sampling{.rays = rays, .least_contrast = -1.0};
    const std::vector<Texel> alone = painter.draw(camera, {sampling});
    const std::vector<Texel> among = painter.draw(wider, {sampling});
    int different = 0, covered = 0;
    float most_coverage = 0.0f;
    for (int row = 0; row < camera.height_px; ++row) {
      for (int column = 0; column < camera.width_px; ++column) {
        const Texel& here = alone[static_cast<std::size_t>(row * camera.width_px + column)];
        const Texel& there =
            among[static_cast<std::size_t>((row + above_px) * wider.width_px + column + aside_px)];
        covered += here[3] > 0.0f ? 1 : 0;
        most_coverage = std::max(most_coverage, here[3]);
        const bool is_same =
            std::abs(here[1] - there[1]) <= 0.02f * std::max(here[1], 0.1f) && here[3] == there[3];
        different += is_same ? 0 : 1;
      }
    }
    std::printf("%d rays: %d of %d pixels differ\n", rays, different, camera.width_px * camera.height_px);
    EXPECT_LE(different, camera.width_px * camera.height_px / 1000) << rays << " rays";
    EXPECT_FLOAT_EQ(most_coverage, 1.0f);
    EXPECT_GT(covered, camera.width_px * camera.height_px / 3);
  }
}

/// Root mean square of what pixels change from frame to frame beyond what those of many rays do, over their
/// mean light: eight frames of an eye that moves by `step_m` and turns by a tenth of a pixel a frame.
double flicker(test::TerrainPainter& painter, const Sampling& sampling, const glm::dvec3& step_m) {
  Camera camera = among_hills();
  std::vector<Texel> last;
  std::vector<Texel> last_reference;
  double light = 0.0, squares = 0.0;
  for (int frame = 0; frame < 8; ++frame) {
    const std::vector<Texel> image = painter.draw(camera, {sampling});
    const std::vector<Texel> reference = painter.draw(camera, {many_rays});
    for (std::size_t i = 0; frame > 0 && i < image.size(); ++i) {
      const double change = static_cast<double>(image[i][1]) - static_cast<double>(last[i][1]);
      const double expected =
          static_cast<double>(reference[i][1]) - static_cast<double>(last_reference[i][1]);
      squares += (change - expected) * (change - expected);
      light += static_cast<double>(reference[i][1]);
    }
    last = image;
    last_reference = reference;
    camera.eye_m += step_m;
    camera.yaw_rad += 0.1 * camera.vertical_field_of_view_rad / camera.height_px;
  }
  const auto count = 7.0 * camera.width_px * camera.height_px;
  return std::sqrt(squares / count) / (light / count);
}

// Of a pixel that an edge moves over, one ray shows all or nothing; of 16 in a grid, the deviation is
// 16^(-3/4), an eighth, of that, and of 4 rays 4^(-3/4), 0.35. What is left is that of pixels with less
// contrast than asks for rays, a share that no bound tells: gate half of one ray's flicker (found: 0.42 to
// 0.45, whether all ground is of one colour or cover changes from post to post). Fails if edges crawl, or if
// pixels change how many rays they get and their light with it.
TEST(TerrainSamplingTest, StandsStillUnderSlowMotion) {
  const test::HeightMap map = hills();
  const test::PaintedTerrain covered = test::PaintedTerrain::covered(map);
  test::PaintedTerrain plain = covered;
  plain.light.sea_level_m = 1e4f;
  for (const test::PaintedTerrain& scene : {plain, covered}) {
    test::TerrainPainter painter(map, scene);
    for (const glm::dvec3& step_m : {glm::dvec3(0.0, 0.0, -0.7), glm::dvec3(0.3, 0.02, -0.1)}) {
      const double of_one = flicker(painter, one_ray, step_m), of_many = flicker(painter, {}, step_m);
      std::printf("flicker: one ray %.4f, automatic %.4f of the mean light\n", of_one, of_many);
      EXPECT_LE(of_many, 0.5 * of_one);
    }
  }
}

TEST(TerrainSamplingTest, RefusesSamplingOutOfRange) {
  const test::HeightMap map = hills();
  test::TerrainPainter painter(map, {});
  for (const Sampling& sampling :
       {Sampling{.rays = 0}, Sampling{.rays = 5000}, Sampling{.least_contrast = std::nan("")}}) {
    EXPECT_THROW(painter.draw(among_hills(), {sampling}), Error);
  }
}

}  // namespace
}  // namespace offing
