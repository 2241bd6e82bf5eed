#include "present/passes/clouds/drawn_clouds.h"

#include "present/passes/view_depth.h"

namespace offing::present {

clouds::DrawnParticles drawn_clouds(const world::World& world) {
  const world::WorldClouds& clouds = *world.clouds();
  const auto& [x, y, z] = world.parameters().sun_direction;
  return {.particles = clouds.particles(),
          .sprites = clouds.sprites(),
          .order = clouds.order(),
          .count = clouds.count(),
          .origin_m = clouds.sky_origin_m(),
          .sun_direction = {x, y, z},
          .near_m = near_m};
}

}  // namespace offing::present
