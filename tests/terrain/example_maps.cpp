#include "tests/terrain/example_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <glm/geometric.hpp>

namespace offing::test {
namespace {

HeightMap made(const std::string& name, const terrain::PostGrid& grid,
               const std::function<double(int, int)>& height_m) {
  HeightMap map{name, grid, {}};
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      map.heights_m.push_back(static_cast<float>(height_m(column, row)));
    }
  }
  return map;
}

}  // namespace

HeightMap square_map(int posts_a_side, double spacing_m,
                     const std::function<double(double x_m, double z_m)>& height_m) {
  const terrain::PostGrid grid{
      .columns = posts_a_side, .rows = posts_a_side, .spacing_x_m = spacing_m, .spacing_z_m = spacing_m};
  return made("made", grid,
              [&](int column, int row) { return height_m(spacing_m * column, spacing_m * row); });
}

terrain::TerrainPosts posts_of(const HeightMap& map) {
  return {.columns = map.grid.columns,
          .rows = map.grid.rows,
          .spacing_x_m = map.grid.spacing_x_m,
          .spacing_z_m = map.grid.spacing_z_m,
          .height_m = [&map](int column, int row) { return map.at(column, row); },
          .is_void = [](int, int) { return false; }};
}

HeightMap valleys(const terrain::PostGrid& grid) {
  return made("valleys", grid, [](int column, int row) {
    return 60.0 * std::sin(0.021 * column) * std::cos(0.017 * row + 0.004 * column) +
           15.0 * std::sin(0.13 * column + 0.11 * row) + 3.0 * std::cos(0.9 * row - 0.7 * column);
  });
}

std::vector<HeightMap> example_maps() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const terrain::PostGrid odd{.columns = 131, .rows = 77, .spacing_x_m = 2.0, .spacing_z_m = 3.0};
  const terrain::PostGrid square{.columns = 65, .rows = 65};
  return {
      made("random", odd, [&](int, int) { return 20.0 * any(random); }),
      made("flat", odd, [](int, int) { return 5.0; }),
      made("spiky", odd, [&](int, int) { return any(random) < 0.02 ? 80.0 : any(random); }),
      made("ramp", odd, [](int column, int row) { return 0.5 * column - 0.25 * row; }),
      made("checkerboard", square, [](int column, int row) { return ((column ^ row) & 1) != 0 ? 4.0 : 0.0; }),
      valleys({.columns = 300,
               .rows = 201,
               .spacing_x_m = 10.0,
               .spacing_z_m = 12.5,
               .origin_x_m = -700.0,
               .origin_z_m = 1300.0})};
}

std::vector<terrain::Ray> example_rays(const HeightMap& map, std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  std::normal_distribution<double> normal;
  const auto [lowest, highest] = std::minmax_element(map.heights_m.begin(), map.heights_m.end());
  const double low_m = *lowest, depth_m = std::max(1.0, static_cast<double>(*highest) - low_m);
  const auto& grid = map.grid;
  const auto pick = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  std::vector<terrain::Ray> rays;
  while (rays.size() < count) {
    // In cells.
    double x = any(random) * (grid.columns - 1), z = any(random) * (grid.rows - 1);
    double y_m = low_m + depth_m * (1.3 * any(random) - 0.1);
    switch (rays.size() % 8) {
      case 0:
        x = pick(0, grid.columns - 1);
        break;
      case 1:
        z = pick(0, grid.rows - 1);
        break;
      case 2:
        x = pick(0, grid.columns - 1), z = pick(0, grid.rows - 1);
        break;
      case 3:
        x += pick(-1, 1) * grid.columns, z += pick(-1, 1) * grid.rows;
        break;
      case 4:
        y_m = *highest;
        break;
      case 5:
        y_m += 3.0 * depth_m;
        break;
      default:
        break;
    }
    glm::dvec3 direction(normal(random), normal(random), normal(random));
    switch (pick(0, 11)) {
      case 0:
        direction = {0.0, any(random) < 0.7 ? -1.0 : 1.0, 0.0};
        break;
      case 1:
        direction.x = 0.0;
        break;
      case 2:
        direction.z = 0.0;
        break;
      case 3:
        direction.y = 0.0;
        break;
      case 4:
        direction = {pick(0, 1) * 2.0 - 1.0, 0.0, 0.0};
        break;
      case 5:
        direction.x = direction.z * grid.spacing_x_m / grid.spacing_z_m;
        break;
      case 6:
        direction.y *= 0.03;
        break;
      default:
        break;
    }
    rays.push_back(
        {.origin_m = {grid.origin_x_m + x * grid.spacing_x_m, y_m, grid.origin_z_m + z * grid.spacing_z_m},
         .direction = glm::normalize(direction)});
  }
  return rays;
}

}  // namespace offing::test
