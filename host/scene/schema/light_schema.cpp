#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

std::vector<Parameter> light_parameters() {
  using enum ParameterMotion;
  constexpr auto lights = &Scene::lights;
  constexpr auto place = &LightScene::place_m;
  constexpr std::size_t max_lights = 32;
  return rows_of_section(
      section_of_list<lights>, ParameterGroup::light, max_lights,
      {{.key = "light.name",
        .storage = &element<lights, &LightScene::name>,
        .help = "for mesh.highlight.light",
        .example = "lantern",
        .absent = "none",
        .rule = ParameterRule::name},
       {.key = "light.kind",
        .storage = choice_at<&element<lights, &LightScene::kind>>({"direction", "place"}),
        .help = "whether it is as far away as the sun, or stands at a place"},
       {.key = "light.azimuth_deg",
        .storage = &element<lights, &LightScene::azimuth_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "where a light of kind direction stands, clockwise from north",
        .scale = radians_per_degree,
        .use = ParameterUse::far_light,
        .motion = keyed_angle},
       {.key = "light.elevation_deg",
        .storage = &element<lights, &LightScene::elevation_rad>,
        .unit = "deg",
        .low = -90.0,
        .high = 90.0,
        .help = "how high it stands above the horizon",
        .scale = radians_per_degree,
        .use = ParameterUse::far_light,
        .motion = keyed},
       {.key = "light.x_m",
        .storage = &element<lights, place, &glm::dvec3::x>,
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "a light of kind place, east of the origin",
        .use = ParameterUse::near_light,
        .motion = keyed},
       {.key = "light.y_m",
        .storage = &element<lights, place, &glm::dvec3::y>,
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "above the mean water level",
        .use = ParameterUse::near_light,
        .motion = keyed},
       {.key = "light.z_m",
        .storage = &element<lights, place, &glm::dvec3::z>,
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "south of the origin",
        .use = ParameterUse::near_light,
        .motion = keyed},
       {.key = "light.colour",
        .storage = &element<lights, &LightScene::colour>,
        .low = 0.0,
        .high = 1.0,
        .help = "red, green and blue, linear Rec.709",
        .motion = keyed},
       {.key = "light.illuminance_klx",
        .storage = &element<lights, &LightScene::illuminance_klx>,
        .unit = "klx",
        .low = 0.0,
        .high = 1000.0,
        .help = "how much light it gives meshes and clouds, however far they are; the sun gives about 100",
        .motion = keyed}});
}

}  // namespace offing::scene
