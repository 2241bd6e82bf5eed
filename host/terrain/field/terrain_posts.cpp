#include "host/terrain/field/terrain_posts.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "host/terrain/field/post_grid.h"

namespace offing::terrain {

namespace {

/// A place in its cell; cells of the last posts end the map.
struct CellPlace {
  int column, row;
  double u, v;
};

std::optional<CellPlace> cell_of(const TerrainPosts& posts, double x_m, double z_m) {
  const double x = place_in_posts(x_m, posts.spacing_x_m, posts.columns),
               z = place_in_posts(z_m, posts.spacing_z_m, posts.rows);
  if (!(x >= 0.0 && x <= posts.columns - 1 && z >= 0.0 && z <= posts.rows - 1)) return std::nullopt;
  const int column = std::min(static_cast<int>(x), posts.columns - 2);
  const int row = std::min(static_cast<int>(z), posts.rows - 2);
  return CellPlace{column, row, x - column, z - row};
}

double height_of(const TerrainPosts& posts, int column, int row) {
  return static_cast<double>(posts.height_m(column, row));
}

/// Mean slopes (east, south) between a post's neighbours, m/m.
glm::dvec2 slopes_of_post(const TerrainPosts& posts, int column, int row) {
  const int west = std::max(column - 1, 0), east = std::min(column + 1, posts.columns - 1);
  const int north = std::max(row - 1, 0), south = std::min(row + 1, posts.rows - 1);
  return {(height_of(posts, east, row) - height_of(posts, west, row)) / ((east - west) * posts.spacing_x_m),
          (height_of(posts, column, south) - height_of(posts, column, north)) /
              ((south - north) * posts.spacing_z_m)};
}

/// Answers about `map`, which `keeper` keeps or points to.
template <class Keeper>
TerrainPosts posts_in(const HeightMap& map, const Keeper& keeper) {
  return {.columns = map.columns,
          .rows = map.rows,
          .spacing_x_m = map.spacing_x_m,
          .spacing_z_m = map.spacing_z_m,
          .height_m = [keeper](int column, int row) { return keeper->heights_m[keeper->index(column, row)]; },
          .is_void =
              [keeper](int column, int row) {
                return !keeper->is_void.empty() && keeper->is_void[keeper->index(column, row)] != 0;
              }};
}

}  // namespace

TerrainPosts posts_of(const HeightMap& map) {
  return posts_in(map, &map);
}

TerrainPosts posts_of(const std::shared_ptr<const HeightMap>& map) {
  return posts_in(*map, map);
}

std::optional<TerrainPoint> terrain_at(const TerrainPosts& posts, double x_m, double z_m) {
  const std::optional<CellPlace> place = cell_of(posts, x_m, z_m);
  if (!place) return std::nullopt;
  const auto [column, row, u, v] = *place;
  const double h0 = height_of(posts, column, row);
  const double a = height_of(posts, column + 1, row) - h0, b = height_of(posts, column, row + 1) - h0;
  const double c = height_of(posts, column + 1, row + 1) - h0 - a - b;
  const glm::dvec3 normal(-(a + c * v) / posts.spacing_x_m, 1.0, -(b + c * u) / posts.spacing_z_m);
  return TerrainPoint{h0 + a * u + b * v + c * u * v, glm::normalize(normal)};
}

std::optional<TerrainPoint> terrain_at(const HeightMap& map, double x_m, double z_m) {
  return terrain_at(posts_of(map), x_m, z_m);
}

std::optional<glm::dvec3> smooth_normal_at(const TerrainPosts& posts, double x_m, double z_m) {
  const std::optional<CellPlace> place = cell_of(posts, x_m, z_m);
  if (!place) return std::nullopt;
  const auto [column, row, u, v] = *place;
  const glm::dvec2 north =
      glm::mix(slopes_of_post(posts, column, row), slopes_of_post(posts, column + 1, row), u);
  const glm::dvec2 south =
      glm::mix(slopes_of_post(posts, column, row + 1), slopes_of_post(posts, column + 1, row + 1), u);
  const glm::dvec2 slopes = glm::mix(north, south, v);
  return glm::normalize(glm::dvec3(-slopes.x, 1.0, -slopes.y));
}

std::optional<glm::dvec3> smooth_normal_at(const HeightMap& map, double x_m, double z_m) {
  return smooth_normal_at(posts_of(map), x_m, z_m);
}

std::optional<bool> is_measured_at(const TerrainPosts& posts, double x_m, double z_m) {
  const std::optional<CellPlace> place = cell_of(posts, x_m, z_m);
  if (!place) return std::nullopt;
  const auto [column, row, u, v] = *place;
  // Posts without a share in the height do not count.
  for (int right = u > 0.0 ? 1 : 0; right >= (u < 1.0 ? 0 : 1); --right) {
    for (int down = v > 0.0 ? 1 : 0; down >= (v < 1.0 ? 0 : 1); --down) {
      if (posts.is_void(column + right, row + down)) return false;
    }
  }
  return true;
}

}  // namespace offing::terrain
