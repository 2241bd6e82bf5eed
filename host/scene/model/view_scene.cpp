#include "host/scene/model/view_scene.h"

namespace offing::scene {

sky::Sun sun_of(const ViewScene& view) {
  const auto& [azimuth_rad, elevation_rad] = view.sun_direction;
  return {.sun_direction = sky::direction_of(azimuth_rad, elevation_rad),
          .sun_distance_au = view.sun_distance_au};
}

sky::Atmosphere atmosphere_of(const ViewScene& view) {
  // What the optical depths of an Atmosphere made by default belong to.
  constexpr double standard_ozone_du = 300.0, standard_pressure_pa = 101'325.0;
  sky::Atmosphere atmosphere = view.atmosphere;
  for (double& depth : atmosphere.ozone_optical_depth) depth *= view.ozone_du / standard_ozone_du;
  for (double& depth : atmosphere.rayleigh_optical_depth) depth *= view.pressure_pa / standard_pressure_pa;
  if (view.ground_albedo) atmosphere.ground_albedo.fill(*view.ground_albedo);
  return atmosphere;
}

}  // namespace offing::scene
