#include "host/terrain/ground.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace offing::terrain {

std::optional<GroundPoint> ground_at(const HeightMap& map, double x_m, double z_m) {
  const double x = x_m / map.spacing_x_m, z = z_m / map.spacing_z_m;
  if (!(x >= 0.0 && x <= map.columns - 1 && z >= 0.0 && z <= map.rows - 1)) return std::nullopt;
  const int column = std::min(static_cast<int>(x), map.columns - 2);
  const int row = std::min(static_cast<int>(z), map.rows - 2);
  const auto height_m = [&](int right, int down) {
    return static_cast<double>(map.heights_m[map.index(column + right, row + down)]);
  };
  const double u = x - column, v = z - row, h0 = height_m(0, 0);
  const double a = height_m(1, 0) - h0, b = height_m(0, 1) - h0, c = height_m(1, 1) - h0 - a - b;
  const glm::dvec3 normal(-(a + c * v) / map.spacing_x_m, 1.0, -(b + c * u) / map.spacing_z_m);
  return GroundPoint{h0 + a * u + b * v + c * u * v, glm::normalize(normal)};
}

}  // namespace offing::terrain
