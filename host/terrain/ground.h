#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "host/base/height_map.h"

namespace offing::terrain {

/// The ground above or below a point of the plan.
struct GroundPoint {
  double height_m = 0.0;
  glm::dvec3 normal{0.0, 1.0, 0.0};  ///< unit, of the point's own patch
};

/// The surface of bilinear patches at (x_m, z_m) from the map's first post, in double precision; nothing
/// beyond the map's edge. The same surface that rays hit.
std::optional<GroundPoint> ground_at(const HeightMap& map, double x_m, double z_m);

/// The unit normal at (x_m, z_m) that goes on smoothly from patch to patch, as HitNormals::smooth has it;
/// nothing beyond the map's edge.
std::optional<glm::dvec3> smooth_normal_at(const HeightMap& map, double x_m, double z_m);

}  // namespace offing::terrain
