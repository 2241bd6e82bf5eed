#include "host/scene/world_scene.h"

#include <utility>

#include "host/scene/sea.h"
#include "host/sky/sun_position.h"

namespace offing::scene {

world::WorldParameters prepare_world(const OceanScene& scene) {
  const OceanScene resolved = with_resolved_wind(scene);
  Sea sea = prepare_sea(scene);
  ocean::TrochoidSea trochoids = trochoids_of(sea, sea.parameters.seed);
  return {.spectrum = std::move(sea.spectrum),
          .ocean = std::move(sea.parameters),
          .trochoids = std::move(trochoids),
          .wind_speed_mps = resolved.wind_speed_mps,
          .wind_direction_rad = resolved.wind_direction_rad,
          .sun_direction = sky::direction_of(scene.view.sun_azimuth_rad, scene.view.sun_elevation_rad)};
}

}  // namespace offing::scene
