#include "host/ocean/query/depth_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/ocean/ocean_limits.h"
#include "kernels/shared/shoal_params.h"

namespace offing::ocean {
namespace {

std::size_t place(const DepthMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
         static_cast<std::size_t>(column);
}

/// One pass over the map in memory order, or against it: what neighbours that have been passed allow.
void limit_by_passed(DepthMap& map, int direction) {
  const auto along_x = static_cast<float>(SHOAL_STEEPEST * map.spacing_x_m);
  const auto along_z = static_cast<float>(SHOAL_STEEPEST * map.spacing_z_m);
  const auto diagonal = static_cast<float>(SHOAL_STEEPEST * std::hypot(map.spacing_x_m, map.spacing_z_m));
  const auto at = [&](int column, int row) -> float {
    const bool is_inside = column >= 0 && column < map.columns && row >= 0 && row < map.rows;
    return is_inside ? map.depths_m[place(map, column, row)] : std::numeric_limits<float>::infinity();
  };
  for (int i = 0; i < map.rows; ++i) {
    const int row = direction > 0 ? i : map.rows - 1 - i;
    for (int j = 0; j < map.columns; ++j) {
      const int column = direction > 0 ? j : map.columns - 1 - j;
      float& depth_m = map.depths_m[place(map, column, row)];
      depth_m =
          std::min({depth_m, at(column - direction, row) + along_x, at(column, row - direction) + along_z,
                    at(column - direction, row - direction) + diagonal,
                    at(column + direction, row - direction) + diagonal});
    }
  }
}

}  // namespace

double DepthMap::depth_m(double x_m, double z_m) const {
  const double column = (x_m - origin_x_m) / spacing_x_m, row = (z_m - origin_z_m) / spacing_z_m;
  const double near_column = std::clamp(column, 0.0, columns - 1.0);
  const double near_row = std::clamp(row, 0.0, rows - 1.0);
  const int x = std::min(static_cast<int>(near_column), columns - 2);
  const int z = std::min(static_cast<int>(near_row), rows - 2);
  const double u = near_column - x, v = near_row - z;
  const auto post_m = [&](int i, int j) -> double { return depths_m[place(*this, x + i, z + j)]; };
  const double inside_m = (1.0 - v) * ((1.0 - u) * post_m(0, 0) + u * post_m(1, 0)) +
                          v * ((1.0 - u) * post_m(0, 1) + u * post_m(1, 1));
  const double beyond_m = std::hypot((column - near_column) * spacing_x_m, (row - near_row) * spacing_z_m);
  return inside_m + SHOAL_STEEPEST * beyond_m;
}

float DepthMap::shallowest_m() const {
  return *std::min_element(depths_m.begin(), depths_m.end());
}

void limit_slopes(DepthMap& map) {
  limit_by_passed(map, 1);
  limit_by_passed(map, -1);
}

void require_valid_depths(const DepthMap& map) {
  constexpr double most_posts = 0x1p28;
  require_within("depth map columns", map.columns, 2.0, most_posts / 2.0);
  require_within("depth map rows", map.rows, 2.0, most_posts / map.columns);
  require_within("depth map spacing_x_m", map.spacing_x_m, 1e-3, 1e6);
  require_within("depth map spacing_z_m", map.spacing_z_m, 1e-3, 1e6);
  require_within("depth map origin_x_m", map.origin_x_m, -farthest_point_m, farthest_point_m);
  require_within("depth map origin_z_m", map.origin_z_m, -farthest_point_m, farthest_point_m);
  const std::size_t posts = place(map, 0, map.rows);
  if (map.depths_m.size() != posts) {
    throw Error(ErrorKind::bad_input,
                fmt::format("depth map: expected {} x {} depths, found {}", map.rows, map.columns,
                            map.depths_m.size()),
                "give a depth for each post, row by row");
  }
  const auto is_finite = [](float depth_m) { return std::isfinite(depth_m); };
  if (!std::all_of(map.depths_m.begin(), map.depths_m.end(), is_finite)) {
    throw Error(ErrorKind::bad_input, "depth map: expected finite depths, found one that is not",
                "fill in the missing depths");
  }
}

}  // namespace offing::ocean
