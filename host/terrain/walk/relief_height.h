#pragma once

#include <glm/vec3.hpp>

#include "host/terrain/cast/relief_surface.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::terrain {

/// Metres by which relief raises the drawn ground at (x_m, z_m) from the first post, for an eye at `eye_m`:
/// what a ReliefSurface adds at a post there, without its bowl. 0 beyond the map's edge.
double relief_height_m(const TerrainPosts& posts, const ReliefSettings& settings, double x_m, double z_m,
                       const glm::dvec3& eye_m);

}  // namespace offing::terrain
