#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "host/base/height_map.h"

/// Where an eye is: above, within or beside a ground.
namespace offing::terrain {

/// The box of a ground whose first post is at x = z = 0.
struct TerrainExtent {
  double width_m = 0.0, depth_m = 0.0;  ///< along x and z
  double highest_m = 0.0;
};

TerrainExtent extent_of(const HeightMap& map);

/// Lifts an eye that is on or below ground of this height to `above_m` above it: from within the ground there
/// is nothing to see. Returns a warning of where it was; nothing for an eye above the ground, which stays.
std::optional<std::string> lift_out_of_terrain(glm::dvec3& eye_m, double terrain_m, double above_m);

/// A warning of an eye that is not over the map, whose first post is at (origin_x_m, origin_z_m); nothing for
/// one that is.
std::optional<std::string> warning_off_map(const glm::dvec3& eye_m, const TerrainExtent& extent,
                                           double origin_x_m = 0.0, double origin_z_m = 0.0);

}  // namespace offing::terrain
