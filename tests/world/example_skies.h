#pragma once

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/clouds/shape/genera.h"
#include "host/world/world_clouds.h"

namespace offing::world {

inline const ocl::Device& device() {
  static const ocl::Device opened = ocl::Device::open();
  return opened;
}

inline clouds::CloudParameters still_cloud(const glm::dvec3& position_m, double radius_m) {
  clouds::CloudParameters cloud = clouds::preset(clouds::Genus::cumulus);
  cloud.balls = {{glm::dvec3(0.0), radius_m}, {glm::dvec3(radius_m, 0.0, 0.0), 0.5 * radius_m}};
  cloud.levels.resize(1);
  cloud.base_m.reset();
  cloud.position_m = position_m;
  cloud.motion = {};
  return cloud;
}

inline CloudSkyParameters two_clouds() {
  return {.clouds = {still_cloud({30'000.0, 1500.0, -200.0}, 150.0),
                     still_cloud({30'900.0, 1700.0, 400.0}, 220.0)}};
}

inline Camera camera_at(const glm::dvec3& eye_m) {
  Camera camera;
  camera.eye_m = eye_m;
  return camera;
}

inline clouds::CloudIllumination daylight() {
  return {.suns = {{.direction = {0.6, 0.8, 0.0}, .illuminance_klx = glm::dvec3(100.0)}},
          .sky_kcdpm2 = {3.0, 4.0, 6.0},
          .ground_kcdpm2 = glm::dvec3(1.0)};
}

}  // namespace offing::world
