#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/base/height_map.h"

namespace offing::terrain {

/// The box of a ground whose first post is at x = z = 0.
struct TerrainExtent {
  double width_m = 0.0, depth_m = 0.0;  ///< along x and z
  double highest_m = 0.0;
};

TerrainExtent extent_of(const HeightMap& map);

/// Over the middle of the southern edge, 300 m above the highest post, looking north and 15 degrees down.
/// Field of view and size are a Camera's own.
Camera flying_camera(const TerrainExtent& extent);

/// Lifts an eye that is on or below ground of this height to `above_m` above it: from within the ground there
/// is nothing to see. Returns a warning of where it was; nothing for an eye above the ground, which stays.
std::optional<std::string> lift_out_of_terrain(glm::dvec3& eye_m, double terrain_m, double above_m);

/// A warning of an eye that is not over the map, whose first post is at (origin_x_m, origin_z_m); nothing for
/// one that is.
std::optional<std::string> warning_off_map(const glm::dvec3& eye_m, const TerrainExtent& extent,
                                           double origin_x_m = 0.0, double origin_z_m = 0.0);

}  // namespace offing::terrain
