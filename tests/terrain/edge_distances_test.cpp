// How far away the ground of partly covered pixels is drawn, against the same rule in double precision.
#include "host/terrain/shading/edge_distances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"
#include "tests/terrain/example_maps.h"
#include "tests/terrain/example_tiles.h"

namespace offing {
namespace {

constexpr int width = 37, height = 23;
constexpr float infinite = std::numeric_limits<float>::infinity();

/// Distances and coverages of pixels without order.
struct Picture {
  std::vector<float> distances_m;
  std::vector<terrain::Texel> image;

  double distance_m(int column, int row) const {
    return static_cast<double>(distances_m.at(static_cast<std::size_t>(row * width + column)));
  }
  float coverage(int column, int row) const {
    return image.at(static_cast<std::size_t>(row * width + column))[3];
  }
};

Picture random_picture() {
  std::mt19937 engine(20261130);
  std::uniform_int_distribution<int> sixteenths(-8, 24);
  std::uniform_real_distribution<float> distance(20.0f, 2000.0f);
  std::bernoulli_distribution misses(0.3);
  Picture picture;
  for (int i = 0; i < width * height; ++i) {
    picture.distances_m.push_back(misses(engine) ? infinite : distance(engine));
    picture.image.push_back(
        {1.0f, 1.0f, 1.0f, static_cast<float>(std::clamp(sixteenths(engine), 0, 16)) / 16.0f});
  }
  return picture;
}

/// As far as the nearest of the pixels beside that ground covers, else of those that it covers in part.
double distance_beside(const Picture& picture, int column, int row) {
  bool has_whole = false, has_part = false;
  double whole_m = 0.0, part_m = 0.0;
  for (const auto& [right, down] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    const int x = std::clamp(column + right, 0, width - 1), y = std::clamp(row + down, 0, height - 1);
    const double there_m = picture.distance_m(x, y);
    if (picture.coverage(x, y) == 1.0f) {
      whole_m = has_whole ? std::min(whole_m, there_m) : there_m;
      has_whole = true;
    } else if (picture.coverage(x, y) > 0.0f) {
      part_m = has_part ? std::min(part_m, there_m) : there_m;
      has_part = true;
    }
  }
  if (has_whole) return whole_m;
  return has_part ? part_m : picture.distance_m(column, row);
}

// Fails if a pixel's distance is not its own where ground covers it or its ray meets ground over the sea, or
// elsewhere not that of the ground beside it: at the picture's sides, next to misses, beside pixels that are
// covered in part as well. Rays whose end lies within 0.01 m of the sea may go either way; floats are right
// to 1e-3 m there.
TEST(EdgeDistancesTest, TakesDistancesOfTheGroundBeside) {
  const ocl::Device device = ocl::Device::open();
  const test::HeightMap map = test::square_map(33, 50.0, [](double, double) { return 0.0; });
  const terrain::HeightField field(device, map.grid, map.heights_m);
  const Camera camera{.eye_m = {800.0, 60.0, 800.0},
                      .yaw_rad = 0.4,
                      .pitch_rad = -0.2,
                      .roll_rad = 0.1,
                      .width_px = width,
                      .height_px = height};
  const terrain::SeaOverTerrain sea{.below_m = -40.0, .bend_perm = 1e-4};
  const Picture picture = random_picture();
  const ocl::Buffer<float> distances_m(device, picture.distances_m, "distances");
  const ocl::Buffer<terrain::Texel> image(device, picture.image, "image");
  ocl::Buffer<float> drawn_m(device, picture.distances_m.size(), "drawn");
  terrain::EdgeDistances(device).at(field, camera, sea, image, distances_m, drawn_m);
  const std::vector<float> found = drawn_m.read();
  std::size_t own = 0, beside = 0, bent = 0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double own_m = picture.distance_m(column, row),
                   coverage = static_cast<double>(picture.coverage(column, row));
      const glm::dvec2 clip(2.0 * (column + 0.5) / width - 1.0, 1.0 - 2.0 * (row + 0.5) / height);
      const double end_m = camera.eye_m.y + own_m * glm::normalize(ray_direction(camera, clip)).y;
      const double above_m = end_m - (sea.below_m - sea.bend_perm * own_m * own_m);
      if (std::abs(above_m) < 0.01) continue;
      const bool is_edge = coverage > 0.0 && coverage < 1.0;
      const bool is_own = !is_edge || (std::isfinite(own_m) && above_m > 0.0);
      ++(is_own ? own : beside);
      if (is_edge && is_own && end_m < sea.below_m) ++bent;
      const double expected_m = is_own ? own_m : distance_beside(picture, column, row);
      EXPECT_EQ(static_cast<double>(found[static_cast<std::size_t>(row * width + column)]), expected_m)
          << column << ", " << row << ": " << coverage;
    }
  }
  EXPECT_GT(own, 300u);
  EXPECT_GT(beside, 150u);
  EXPECT_GT(bent, 10u);
}

// Fails if the same picture of tiles does not take the same distances.
TEST(EdgeDistancesTest, DoesSoOverTiles) {
  const ocl::Device device = ocl::Device::open();
  const test::ExampleTiles example = test::hilly_tiles();
  terrain::TiledField tiles(device, example.tiled_map(), example.reader(), std::size_t{64} << 20);
  const terrain::HeightField map(device, example.map().grid, example.map().heights_m);
  const Camera camera{
      .eye_m = {800.0, 60.0, 800.0}, .pitch_rad = -0.2, .width_px = width, .height_px = height};
  tiles.look_and_wait(camera);
  const Picture picture = random_picture();
  const ocl::Buffer<float> distances_m(device, picture.distances_m, "distances");
  const ocl::Buffer<terrain::Texel> image(device, picture.image, "image");
  ocl::Buffer<float> of_map_m(device, picture.distances_m.size(), "of the map"),
      of_tiles_m(device, picture.distances_m.size(), "of tiles");
  const terrain::EdgeDistances edges(device);
  const terrain::SeaOverTerrain sea{.below_m = -40.0};
  edges.at(map, camera, sea, image, distances_m, of_map_m);
  edges.at(tiles, camera, sea, image, distances_m, of_tiles_m);
  EXPECT_EQ(of_tiles_m.read(), of_map_m.read());
}

// Fails if a kernel reads or writes beyond a buffer.
TEST(EdgeDistancesTest, RefusesSmallBuffers) {
  const ocl::Device device = ocl::Device::open();
  const test::HeightMap map = test::square_map(5, 10.0, [](double, double) { return 0.0; });
  const terrain::HeightField field(device, map.grid, map.heights_m);
  const Camera camera{.width_px = 4, .height_px = 4};
  const terrain::EdgeDistances edges(device);
  for (const std::size_t small : {0u, 1u, 2u}) {
    const auto size = [small](std::size_t which) {
      return which == small ? std::size_t{15} : std::size_t{16};
    };
    const ocl::Buffer<terrain::Texel> image(device, size(0), "image");
    const ocl::Buffer<float> distances_m(device, size(1), "distances");
    ocl::Buffer<float> drawn_m(device, size(2), "drawn");
    const std::string name = std::array{"image", "distances", "drawn distances"}.at(small);
    test::expect_error(ErrorKind::bad_usage, name,
                       [&] { edges.at(field, camera, {}, image, distances_m, drawn_m); });
  }
}

}  // namespace
}  // namespace offing
