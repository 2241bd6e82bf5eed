#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/clouds/image/billboard_textures.h"
#include "kernels/shared/clouds.h"

namespace offing::test {

/// What a ray sees of clouds.
struct CloudSight {
  std::array<double, 4> rgba{};  ///< premultiplied
  double distance_m = 0.0;
};

/// In double precision, one ray at a time and each layer apart, what kernels/clouds/billboard_composite.cl
/// gives. `direction` is the unit ray of the pixel; particles in any order, without those that are none.
CloudSight reference_sight(std::span<const CloudParticle> particles, std::span<const CloudSprite> sprites,
                           const clouds::BillboardTextures& textures, const Camera& camera,
                           const glm::dvec3& sun_direction, const glm::dvec3& direction, double scene_m);

/// Integral of C1's density along a chord that passes the middle at so many radii, between two places of it
/// in radii from the nearest point; by Simpson's rule.
double chord_integral(double offset, double begin, double end);

}  // namespace offing::test
