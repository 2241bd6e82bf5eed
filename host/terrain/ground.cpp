#include "host/terrain/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace offing::terrain {

namespace {

/// A place in its cell; cells of the last posts end the map.
struct CellPlace {
  int column, row;
  double u, v;
};

/// The last post's place is a product, which the quotient may miss by a rounding of each.
constexpr double past_last_post = 1.0 + 2.0 * std::numeric_limits<double>::epsilon();

std::optional<CellPlace> cell_of(const HeightMap& map, double x_m, double z_m) {
  const double x = x_m / map.spacing_x_m, z = z_m / map.spacing_z_m;
  const double last_x = map.columns - 1, last_z = map.rows - 1;
  if (!(x >= 0.0 && x <= past_last_post * last_x && z >= 0.0 && z <= past_last_post * last_z)) {
    return std::nullopt;
  }
  const int column = std::min(static_cast<int>(x), map.columns - 2);
  const int row = std::min(static_cast<int>(z), map.rows - 2);
  return CellPlace{column, row, std::min(x - column, 1.0), std::min(z - row, 1.0)};
}

double height_of(const HeightMap& map, int column, int row) {
  return static_cast<double>(map.heights_m[map.index(column, row)]);
}

/// Mean slopes (east, south) between a post's neighbours, m/m.
glm::dvec2 slopes_of_post(const HeightMap& map, int column, int row) {
  const int west = std::max(column - 1, 0), east = std::min(column + 1, map.columns - 1);
  const int north = std::max(row - 1, 0), south = std::min(row + 1, map.rows - 1);
  return {
      (height_of(map, east, row) - height_of(map, west, row)) / ((east - west) * map.spacing_x_m),
      (height_of(map, column, south) - height_of(map, column, north)) / ((south - north) * map.spacing_z_m)};
}

}  // namespace

std::optional<GroundPoint> ground_at(const HeightMap& map, double x_m, double z_m) {
  const std::optional<CellPlace> place = cell_of(map, x_m, z_m);
  if (!place) return std::nullopt;
  const auto [column, row, u, v] = *place;
  const double h0 = height_of(map, column, row);
  const double a = height_of(map, column + 1, row) - h0, b = height_of(map, column, row + 1) - h0;
  const double c = height_of(map, column + 1, row + 1) - h0 - a - b;
  const glm::dvec3 normal(-(a + c * v) / map.spacing_x_m, 1.0, -(b + c * u) / map.spacing_z_m);
  return GroundPoint{h0 + a * u + b * v + c * u * v, glm::normalize(normal)};
}

std::optional<glm::dvec3> smooth_normal_at(const HeightMap& map, double x_m, double z_m) {
  const std::optional<CellPlace> place = cell_of(map, x_m, z_m);
  if (!place) return std::nullopt;
  const auto [column, row, u, v] = *place;
  const glm::dvec2 north =
      glm::mix(slopes_of_post(map, column, row), slopes_of_post(map, column + 1, row), u);
  const glm::dvec2 south =
      glm::mix(slopes_of_post(map, column, row + 1), slopes_of_post(map, column + 1, row + 1), u);
  const glm::dvec2 slopes = glm::mix(north, south, v);
  return glm::normalize(glm::dvec3(-slopes.x, 1.0, -slopes.y));
}

}  // namespace offing::terrain
