#include "host/scene/view_parameters.h"

#include <glm/vec3.hpp>

#include "host/scene/parameter_storage.h"

namespace offing::scene {

std::vector<Parameter> view_parameters() {
  using enum ParameterGroup;
  using enum ParameterMotion;
  constexpr auto view = &OceanScene::view;
  constexpr auto eye_camera = &ViewScene::camera;
  constexpr auto eye = &Camera::eye_m;
  return {
      {.key = "camera.x_m",
       .flag = "",
       .group = camera,
       .storage = &member<view, eye_camera, eye, &glm::dvec3::x>,
       .unit = "m",
       .low = -1e7,
       .high = 1e7,
       .help = "the eye, east of the origin",
       .motion = keyed},
      {.key = "camera.y_m",
       .flag = "",
       .group = camera,
       .storage = &member<view, eye_camera, eye, &glm::dvec3::y>,
       .unit = "m",
       .low = 0.001,
       .high = 50e3,
       .help = "the eye, above the mean water level",
       .motion = keyed},
      {.key = "camera.z_m",
       .flag = "",
       .group = camera,
       .storage = &member<view, eye_camera, eye, &glm::dvec3::z>,
       .unit = "m",
       .low = -1e7,
       .high = 1e7,
       .help = "the eye, south of the origin",
       .motion = keyed},
      {.key = "camera.yaw_deg",
       .flag = "",
       .group = camera,
       .storage = &member<view, eye_camera, &Camera::yaw_rad>,
       .unit = "deg",
       .low = -360.0,
       .high = 360.0,
       .help = "where the eye looks, clockwise from north (-z)",
       .scale = radians_per_degree,
       .motion = keyed_angle},
      {.key = "camera.pitch_deg",
       .flag = "",
       .group = camera,
       .storage = &member<view, eye_camera, &Camera::pitch_rad>,
       .unit = "deg",
       .low = -90.0,
       .high = 90.0,
       .help = "how far up the eye looks",
       .scale = radians_per_degree,
       .motion = keyed},
      {.key = "camera.roll_deg",
       .flag = "",
       .group = camera,
       .storage = &member<view, eye_camera, &Camera::roll_rad>,
       .unit = "deg",
       .low = -180.0,
       .high = 180.0,
       .help = "how far the head is turned clockwise",
       .scale = radians_per_degree,
       .motion = keyed_angle},
      {.key = "camera.fov_deg",
       .flag = "",
       .group = camera,
       .storage = &member<view, eye_camera, &Camera::vertical_field_of_view_rad>,
       .unit = "deg",
       .low = 1.0,
       .high = 150.0,
       .help = "height of the field of view",
       .scale = radians_per_degree,
       .motion = keyed},

      {.key = "render.exposure_ev",
       .flag = "",
       .group = render,
       .storage = &member<view, &ViewScene::exposure_ev>,
       .low = -20.0,
       .high = 20.0,
       .help = "stops above the exposure that the light at the eye asks for",
       .motion = keyed},
  };
}

}  // namespace offing::scene
