#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

std::string needs_direction(const UseContext&, const LightScene& light) {
  return light.kind == LightKind::direction ? "" : "the light stands at a place";
}

std::string needs_place(const UseContext&, const LightScene& light) {
  return light.kind == LightKind::place ? "" : "the light is of kind direction";
}

}  // namespace

Schema<LightScene> light_schema() {
  using enum ParameterMotion;
  constexpr auto place = &LightScene::place_m;
  Schema<LightScene> schema("light");
  return schema.rows(
      ParameterGroup::light, Affects::lights,
      {{&LightScene::name,
        {.key = "name",
         .help = "name that mesh.highlight.light refers to",
         .example = "lantern",
         .absent = "none",
         .rule = ParameterRule::name}},
       {choice(&LightScene::kind, {"direction", "place"}),
        {.key = "kind", .help = "direction: infinitely far away, like the sun; place: at a position"}},
       {&LightScene::azimuth_rad,
        {.key = "azimuth_deg",
         .unit = "deg",
         .low = -360.0,
         .high = 360.0,
         .help = "direction of a light of kind direction, clockwise from north",
         .scale = radians_per_degree,
         .motion = keyed_angle},
        needs_direction},
       {&LightScene::elevation_rad,
        {.key = "elevation_deg",
         .unit = "deg",
         .low = -90.0,
         .high = 90.0,
         .help = "its height above the horizon",
         .scale = radians_per_degree,
         .motion = keyed},
        needs_direction},
       {path(place, &glm::dvec3::x),
        {.key = "x_m",
         .unit = "m",
         .low = -1e7,
         .high = 1e7,
         .help = "position of a light of kind place, east of the origin",
         .motion = keyed},
        needs_place},
       {path(place, &glm::dvec3::y),
        {.key = "y_m",
         .unit = "m",
         .low = -1e7,
         .high = 1e7,
         .help = "height, from the same zero as terrain heights",
         .motion = keyed},
        needs_place},
       {path(place, &glm::dvec3::z),
        {.key = "z_m",
         .unit = "m",
         .low = -1e7,
         .high = 1e7,
         .help = "position, south of the origin",
         .motion = keyed},
        needs_place},
       {&LightScene::colour,
        {.key = "colour",
         .low = 0.0,
         .high = 1.0,
         .help = "colour of the light: red, green and blue, linear Rec.709",
         .motion = keyed}},
       {&LightScene::illuminance_klx,
        {.key = "illuminance_klx",
         .unit = "klx",
         .low = 0.0,
         .high = 1000.0,
         .help = "illuminance of meshes and clouds at any distance; the sun gives about 100",
         .motion = keyed}}});
}

}  // namespace offing::scene
