#pragma once

#include <glm/vec3.hpp>

#include "host/world/world.h"

namespace offing::present {

/// Of the light that comes up to the surface of deep water about half is turned back.
inline constexpr float water_leaving_share = 0.54f;

/// What the water of a world does to light (ocean::water_optics()) at red, green and blue.
struct WaterLight {
  glm::vec3 attenuation_perm;
  /// Light that deep water sends up through its surface: what was the sky's, and the sun's where no cloud
  /// stands before it.
  glm::vec3 of_sky_kcdpm2, of_sun_kcdpm2;
};

WaterLight water_light(const world::World& world);

}  // namespace offing::present
