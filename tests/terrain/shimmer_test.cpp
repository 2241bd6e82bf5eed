// Thirty-two frames on foot and in flight: what the ground's pictures change by from frame to frame, beside
// what 64 rays a pixel change by. Fails if they shimmer: if edges get too few rays, or noise is not filtered
// over what pixels see.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/generate/fractal_terrain.h"
#include "host/terrain/walk/relief_height.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Sampling;
using terrain::Texel;

constexpr int frames = 32;
// Aliasing is what pictures change by from frame to frame beyond what 64 rays a pixel change by. It has two
// limits, of which one is to be met.
// - A share of the mean light. Bound 0.08: a pixel with one ray differs from its mean by half of its contrast
//   of 0.2 at most, from frame to frame by 0.1 sqrt(2 / 3) on the mean if every pixel had as much and frames
//   had nothing to do with each other. Most have less contrast, and neighbouring frames see nearly the same.
//   Found 0.0023 ... 0.0129; limit 0.016.
// - Where stones and edges pass the eye, a share of the movement: at most a tenth of its energy. Footprints
//   leave 7 % of an octave's energy unexplained where its cells are as large as they are, 1 % where they are
//   twice as large (terrain_noise.clh). Of an edge 16 rays leave 16^(-3/2), 2 %, where 4 rays leave 12 %.
//   Found 0.084 on the Andes' summit with relief, whose 64 rays change by 0.08 of the light: 0.30 when
//   edges of snow had 4 rays, 0.42 where noise is filtered over a quarter of its footprints.
// And 0.8 of what one ray a pixel flickers by (found 0.20 ... 0.68), unless that is less than half a percent:
// on the snow of the Andes' summit one ray is as still as many, 0.0046.
constexpr double most_flicker = 0.016, most_of_movement = 0.1, most_of_one_ray = 0.8, still = 0.005;
constexpr Sampling one_ray{.rays = 1}, automatic{}, many_rays{.rays = 64, .least_contrast = -1.0};

/// A fifth of a picture of 1280 x 720 pixels and 60 degrees, with pixels as large, around the horizon.
Camera small_camera() {
  return {.vertical_field_of_view_rad = 12.0 / 180.0 * std::numbers::pi, .width_px = 256, .height_px = 144};
}

/// Where relief reaches, between the map's highest and lowest post.
terrain::ReliefSettings relief_over(const HeightMap& map) {
  const auto [lowest, highest] = std::minmax_element(map.heights_m.begin(), map.heights_m.end());
  const auto between = [&](double share) {
    return (1.0 - share) * static_cast<double>(*lowest) + share * static_cast<double>(*highest);
  };
  return {.shore_m = between(0.1), .tree_line_m = between(0.4), .snow_line_m = between(1.5)};
}

/// On foot from the highest post toward the middle of the map, 5 cm a frame, on the ground with relief or
/// without.
std::vector<Camera> walk_over(const HeightMap& map, bool has_relief) {
  const auto highest = std::max_element(map.heights_m.begin(), map.heights_m.end()) - map.heights_m.begin();
  const double x_m = map.spacing_x_m * static_cast<double>(highest % map.columns),
               z_m = map.spacing_z_m * static_cast<double>(highest / map.columns);
  const glm::dvec2 way = glm::normalize(glm::dvec2(0.5 * map.spacing_x_m * (map.columns - 1) - x_m,
                                                   0.5 * map.spacing_z_m * (map.rows - 1) - z_m));
  std::vector<Camera> cameras;
  for (int frame = 0; frame < frames; ++frame) {
    Camera camera = small_camera();
    camera.yaw_rad = std::atan2(way.x, -way.y);
    camera.pitch_rad = -4.0 / 180.0 * std::numbers::pi;
    const double east_m = x_m + 0.05 * frame * way.x, south_m = z_m + 0.05 * frame * way.y;
    camera.eye_m = {east_m, terrain::terrain_at(map, east_m, south_m)->height_m + 1.7, south_m};
    if (has_relief) {
      camera.eye_m.y +=
          terrain::relief_height_m(terrain::posts_of(map), relief_over(map), east_m, south_m, camera.eye_m);
    }
    cameras.push_back(camera);
  }
  return cameras;
}

/// Over the southern part of the map, 300 m above its highest post, 60 m/s at 30 frames a second.
std::vector<Camera> flight_over(const HeightMap& map) {
  const double highest_m = *std::max_element(map.heights_m.begin(), map.heights_m.end());
  std::vector<Camera> cameras;
  for (int frame = 0; frame < frames; ++frame) {
    Camera camera = small_camera();
    camera.pitch_rad = -6.0 / 180.0 * std::numbers::pi;
    camera.eye_m = {0.5 * map.spacing_x_m * (map.columns - 1), highest_m + 300.0,
                    0.9 * map.spacing_z_m * (map.rows - 1) - 2.0 * frame};
    cameras.push_back(camera);
  }
  return cameras;
}

/// Root mean squares over the mean light: of what pixels change by from frame to frame, and of what is left
/// of it without the change of many rays.
struct Stability {
  double change = 0.0, flicker = 0.0;
};

using Images = std::vector<std::vector<Texel>>;

Images draw(test::TerrainPainter& painter, const std::vector<Camera>& cameras, const Sampling& sampling) {
  Images pictures;
  for (const Camera& camera : cameras) pictures.push_back(painter.draw(camera, {sampling}));
  return pictures;
}

Stability stability_of(const Images& pictures, const Images& reference) {
  double light = 0.0, changes = 0.0, differences = 0.0;
  std::size_t count = 0;
  for (std::size_t frame = 1; frame < pictures.size(); ++frame) {
    for (std::size_t i = 0; i < pictures[frame].size(); ++i, ++count) {
      const auto step = [&](const Images& of) {
        return static_cast<double>(of[frame][i][1]) - static_cast<double>(of[frame - 1][i][1]);
      };
      const double change = step(pictures), difference = change - step(reference);
      changes += change * change;
      differences += difference * difference;
      light += static_cast<double>(reference[frame][i][1]);
    }
  }
  const auto all = static_cast<double>(count);
  return {std::sqrt(changes / all) / (light / all), std::sqrt(differences / all) / (light / all)};
}

void expect_stillness(const std::string& name, const HeightMap& map) {
  const test::HeightMap painted{name,
                                {.columns = map.columns,
                                 .rows = map.rows,
                                 .spacing_x_m = map.spacing_x_m,
                                 .spacing_z_m = map.spacing_z_m},
                                map.heights_m};
  test::TerrainPainter painter(painted, test::PaintedTerrain::covered(painted));
  for (const auto& [way, cameras] :
       {std::pair("walk", walk_over(map, false)), std::pair("fly", flight_over(map)),
        std::pair("walk with relief", walk_over(map, true))}) {
    if (way == std::string_view("walk with relief")) painter.show_relief(relief_over(map));
    const Images reference = draw(painter, cameras, many_rays);
    const Stability of_many = stability_of(reference, reference),
                    of_one = stability_of(draw(painter, cameras, one_ray), reference),
                    found = stability_of(draw(painter, cameras, automatic), reference);
    std::printf(
        "%-20s %-4s change: 64 rays %.4f, automatic %.4f, one ray %.4f; beyond 64 rays: automatic %.4f, one "
        "ray %.4f\n",
        name.c_str(), way, of_many.change, found.change, of_one.change, found.flicker, of_one.flicker);
    EXPECT_LE(found.flicker, std::max(most_flicker, std::sqrt(most_of_movement) * of_many.change))
        << name << ", " << way;
    EXPECT_LE(found.flicker, std::max(most_of_one_ray * of_one.flicker, still)) << name << ", " << way;
  }
}

HeightMap made_valleys() {
  const terrain::FractalParameters parameters{.posts = 1025, .side_m = 20'480.0};
  terrain::FractalTerrain terrain(parameters);
  HeightMap map;
  map.columns = map.rows = parameters.posts;
  map.spacing_x_m = map.spacing_z_m = 20.0;
  map.heights_m.resize(std::size_t{1025} * 1025);
  for (int row = 0; row < parameters.posts; ++row)
    terrain.fill_row(row, std::span(map.heights_m).subspan(map.index(0, row), 1025));
  return map;
}

TEST(ShimmerTest, MadeGroundStandsStill) {
  expect_stillness("valleys 1025", made_valleys());
}

TEST(ShimmerTest, RealGroundStandsStill) {
  const char* const folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr || *folder == '\0')
    GTEST_SKIP() << "OFFING_TEST_DATA is not set: no real height maps";
  for (const char* name : {"S33W071.tif", "N48W125.hgt.zip"}) {
    expect_stillness(name, read_height_map(std::filesystem::path(folder) / "terrain" / name).map);
  }
}

}  // namespace
}  // namespace offing
