#include "host/bodies/hull_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "host/bodies/hull.h"

namespace offing::bodies {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
// Of a side of its triangle's, beyond which a column is not its: columns on an edge are of both sides.
constexpr double edge_tolerance = 1e-9;
// Of the hull's height: hollows of a deck that are less deep than that are no boat.
constexpr double least_hollow = 0.05;

std::size_t place_of(int column, int row) {
  return static_cast<std::size_t>(row) * HullMap::columns + static_cast<std::size_t>(column);
}

/// The columns whose middles lie within a range, along one axis.
std::pair<int, int> columns_within(double from, double to, double low, double cell, int count) {
  return {std::max(0, static_cast<int>(std::ceil((from - low) / cell - 1e-6))),
          std::min(count - 1, static_cast<int>(std::floor((to - low) / cell + 1e-6)))};
}

void draw_face(const std::array<glm::dvec3, 3>& corners, HullMap& map) {
  const auto& [a, b, c] = corners;
  const double twice = (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
  if (twice == 0.0) return;
  const auto [left, right] = columns_within(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), map.low_x_m,
                                            map.cell_x_m, HullMap::columns);
  const auto [low, high] = columns_within(std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z}), map.low_z_m,
                                          map.cell_z_m, HullMap::rows);
  for (int row = low; row <= high; ++row) {
    for (int column = left; column <= right; ++column) {
      const double x = map.low_x_m + column * map.cell_x_m - a.x, z = map.low_z_m + row * map.cell_z_m - a.z;
      const double of_b = (x * (c.z - a.z) - (c.x - a.x) * z) / twice;
      const double of_c = ((b.x - a.x) * z - x * (b.z - a.z)) / twice;
      if (std::min({of_b, of_c, 1.0 - of_b - of_c}) < -edge_tolerance) continue;
      const auto height = static_cast<float>(a.y + of_b * (b.y - a.y) + of_c * (c.y - a.y));
      const std::size_t place = place_of(column, row);
      map.bottom_m[place] = std::min(map.bottom_m[place], height);
      map.top_m[place] = std::max(map.top_m[place], height);
    }
  }
}

/// Water rises around the hull and runs over its lowest places first (Barnes, Lehman & Mulla 2014,
/// "Priority-flood", algorithm 1).
void find_rims(HullMap& map) {
  using Front = std::pair<float, std::pair<int, int>>;  // level, column, row
  std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
  map.rim_m.assign(map.top_m.size(), -infinity);
  std::vector<bool> is_wet(map.top_m.size(), false);
  for (int row = 0; row < HullMap::rows; ++row) {
    for (int column = 0; column < HullMap::columns; ++column) {
      if (map.top_m[place_of(column, row)] != -infinity) continue;
      is_wet[place_of(column, row)] = true;
      front.push({-infinity, {column, row}});
    }
  }
  while (!front.empty()) {
    const auto [level, from] = front.top();
    front.pop();
    for (const auto& [across, along] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int column = from.first + across, row = from.second + along;
      if (column < 0 || column >= HullMap::columns || row < 0 || row >= HullMap::rows) continue;
      const std::size_t place = place_of(column, row);
      if (is_wet[place]) continue;
      is_wet[place] = true;
      map.rim_m[place] = std::max(level, map.top_m[place]);
      front.push({map.rim_m[place], {column, row}});
    }
  }
}

}  // namespace

HullMap map_of_hull(const TriangleMesh& mesh) {
  const Extent extent = extent_of(mesh);
  HullMap map;
  // Half a cell more at each end, and one for the empty column around.
  map.cell_x_m = (extent.high_m.x - extent.low_m.x) / (HullMap::columns - 2);
  map.cell_z_m = (extent.high_m.z - extent.low_m.z) / (HullMap::rows - 2);
  map.low_x_m = extent.low_m.x - 0.5 * map.cell_x_m;
  map.low_z_m = extent.low_m.z - 0.5 * map.cell_z_m;
  const std::size_t count = static_cast<std::size_t>(HullMap::columns) * HullMap::rows;
  map.bottom_m.assign(count, infinity);
  map.top_m.assign(count, -infinity);
  for (const TriangleIndices& face : mesh.faces) {
    draw_face({mesh.positions_m[face[0]], mesh.positions_m[face[1]], mesh.positions_m[face[2]]}, map);
  }
  find_rims(map);
  return map;
}

bool is_open(const HullMap& map) {
  float low_m = infinity, high_m = -infinity, deepest_m = 0.0f;
  for (std::size_t place = 0; place < map.top_m.size(); ++place) {
    if (map.top_m[place] == -infinity) continue;
    low_m = std::min(low_m, map.bottom_m[place]);
    high_m = std::max(high_m, map.top_m[place]);
    deepest_m = std::max(deepest_m, map.rim_m[place] - map.top_m[place]);
  }
  return deepest_m > least_hollow * (high_m - low_m);
}

}  // namespace offing::bodies
