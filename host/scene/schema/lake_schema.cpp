#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

std::string needs_terrain(const UseContext& context, const LakeScene&) {
  return context.scene.terrain.is_given ? "" : "the scene has no terrain";
}

}  // namespace

Schema<LakeScene> lake_schema() {
  Schema<LakeScene> schema("lake");
  return schema.rows(
      ParameterGroup::lake, Affects::cover,
      {{&LakeScene::name,
        {.key = "name",
         .help = "name in the list of objects",
         .example = "tarn",
         .absent = "none",
         .rule = ParameterRule::name},
        needs_terrain},
       {&LakeScene::x_m,
        {.key = "x_m",
         .unit = "m",
         .low = -1e7,
         .high = 1e7,
         .help = "a place in the lake, east of the origin"},
        needs_terrain},
       {&LakeScene::z_m,
        {.key = "z_m",
         .unit = "m",
         .low = -1e7,
         .high = 1e7,
         .help = "a place in the lake, south of the origin"},
        needs_terrain},
       {&LakeScene::level_m,
        {.key = "level_m",
         .unit = "m",
         .low = -2e4,
         .high = 2e4,
         .help = "height of the water, which fills the basin up to this level",
         .example = "3120",
         .absent = "the spill level: full"},
        needs_terrain},
       {&LakeScene::wind_speed_mps,
        {.key = "wind_speed_mps",
         .unit = "m/s",
         .low = 0.0,
         .high = 20.0,
         .help = "wind speed that raises its waves; at 0 it is a mirror"},
        needs_terrain},
       {&LakeScene::wind_direction_rad,
        {.key = "wind_direction_deg",
         .unit = "deg",
         .low = -360.0,
         .high = 360.0,
         .help = "direction in which its waves travel, from +x (east) toward +z (south)",
         .scale = radians_per_degree},
        needs_terrain},
       {choice(&LakeScene::water, {"I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C"}),
        {.key = "water", .help = "Jerlov water type: I clear ... III, 1C ... 9C murky"},
        needs_terrain}});
}

}  // namespace offing::scene
