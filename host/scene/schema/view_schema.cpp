#include <glm/vec3.hpp>

#include "host/base/parameter_check.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;

std::vector<Row<Camera>> camera_rows() {
  constexpr auto eye = &Camera::eye_m;
  return {{path(eye, &glm::dvec3::x),
           {.key = "x_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "position of the eye, east of the origin",
            .motion = keyed}},
          {path(eye, &glm::dvec3::y),
           {.key = "y_m",
            .unit = "m",
            .low = -deepest_m,
            .high = 50e3,
            .help = "height of the eye, from the same zero as terrain heights",
            .motion = keyed}},
          {path(eye, &glm::dvec3::z),
           {.key = "z_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "position of the eye, south of the origin",
            .motion = keyed}},
          {&Camera::yaw_rad,
           {.key = "yaw_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "viewing direction, clockwise from north (-z)",
            .scale = radians_per_degree,
            .motion = keyed_angle}},
          {&Camera::pitch_rad,
           {.key = "pitch_deg",
            .unit = "deg",
            .low = -90.0,
            .high = 90.0,
            .help = "viewing direction, up from the horizon",
            .scale = radians_per_degree,
            .motion = keyed}},
          {&Camera::roll_rad,
           {.key = "roll_deg",
            .unit = "deg",
            .low = -180.0,
            .high = 180.0,
            .help = "roll of the camera, clockwise",
            .scale = radians_per_degree,
            .motion = keyed_angle}},
          {&Camera::vertical_field_of_view_rad,
           {.key = "fov_deg",
            .unit = "deg",
            .low = 1.0,
            .high = 170.0,
            .help = "vertical field of view",
            .scale = radians_per_degree,
            .motion = keyed}}};
}

}  // namespace

Schema<ViewScene> camera_schema() {
  Schema<ViewScene> schema("camera");
  return schema.rows(ParameterGroup::camera, Affects::view, &ViewScene::camera, camera_rows())
      .rows(ParameterGroup::camera, Affects::view,
            {{choice(&ViewScene::mode, {"fly", "walk"}),
              {.key = "mode",
               .help = "how the camera moves in a window; in walk, y_m is the height of the ground plus "
                       "walk.eye_height_m"}}});
}

Schema<ViewScene> walk_schema() {
  using terrain::WalkerParameters;
  constexpr auto walker = &ViewScene::walker;
  Schema<ViewScene> schema("walk");
  return schema.rows(
      ParameterGroup::walk, Affects::view,
      {{path(walker, &WalkerParameters::eye_height_m),
        {.key = "eye_height_m",
         .unit = "m",
         .low = 0.1,
         .high = 1000.0,
         .help = "height of the walker's eye above the ground"}},
       {&ViewScene::walking_mps,
        {.key = "speed_mps",
         .unit = "m/s",
         .low = 0.1,
         .high = 100.0,
         .help = "walking speed; running is five times as fast"}},
       {path(walker, &WalkerParameters::slope_limit_rad),
        {.key = "slope_limit_deg",
         .unit = "deg",
         .low = 1.0,
         .high = 85.0,
         .help = "steepest ground that the walker can stand on; on steeper ground the walker slides down",
         .scale = radians_per_degree}},
       {path(walker, &WalkerParameters::gravity_mps2),
        {.key = "gravity_mps2",
         .unit = "m/s^2",
         .low = 0.01,
         .high = 1000.0,
         .help = "acceleration of gravity when the walker falls"}}});
}

Schema<ViewScene> render_schema() {
  Schema<ViewScene> schema("render");
  return schema.rows(ParameterGroup::render, Affects::view,
                     {{&ViewScene::exposure_ev,
                       {.key = "exposure_ev",
                        .low = -20.0,
                        .high = 20.0,
                        .help = "exposure correction in stops; 0 is automatic exposure",
                        .motion = keyed}}});
}

Schema<BookmarkScene> bookmark_schema() {
  std::vector<Row<Camera>> rows = camera_rows();
  for (Row<Camera>& row : rows) row.facts.motion = constant;
  Schema<BookmarkScene> schema("bookmark");
  return schema
      .rows(ParameterGroup::bookmark, Affects::view,
            {{&BookmarkScene::name,
              {.key = "name",
               .help = "name in the panel of bookmarks",
               .example = "bow",
               .absent = "none",
               .rule = ParameterRule::name}}})
      .rows(ParameterGroup::bookmark, Affects::view, &BookmarkScene::camera, std::move(rows));
}

}  // namespace offing::scene
