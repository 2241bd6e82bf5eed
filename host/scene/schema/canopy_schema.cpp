#include "host/scene/schema/sections.h"

namespace offing::scene {

using terrain::Canopy;

namespace {

std::string needs_rules(const UseContext&, const CanopyScene& canopy) {
  return canopy.map.empty() ? "" : "terrain.canopy.map says where woods are";
}

std::string needs_woods(const UseContext&, const CanopyScene& canopy) {
  return canopy.map.empty() && canopy.wood.share == 0.0 ? "there are no woods: terrain.canopy.share is 0"
                                                        : "";
}

std::string needs_woods_by_rules(const UseContext& context, const CanopyScene& canopy) {
  const std::string why = needs_woods(context, canopy);
  return why.empty() ? needs_rules(context, canopy) : why;
}

}  // namespace

Schema<CanopyScene> canopy_schema() {
  Schema<CanopyScene> schema("canopy");
  constexpr auto wood = &CanopyScene::wood;
  return schema.rows(
      ParameterGroup::canopy, Affects::cover,
      {{&CanopyScene::map,
        {.key = "map",
         .help = "picture of the woods, white where they are dense, black where there are none; lies as "
                 "terrain.colour does",
         .example = "forest.tif",
         .absent = "none: by the rules below",
         .rule = ParameterRule::file_name}},
       {path(wood, &Canopy::share),
        {.key = "share",
         .low = 0.0,
         .high = 1.0,
         .help = "share of the ground between these heights and slopes that woods cover, 0 for none"},
        needs_rules},
       {path(wood, &Canopy::patch_m),
        {.key = "patch_m",
         .unit = "m",
         .low = 50.0,
         .high = 5000.0,
         .help = "approximate size of woods and clearings"},
        needs_woods_by_rules},
       {path(wood, &Canopy::lowest_m),
        {.key = "lowest_m",
         .unit = "m",
         .low = -2e4,
         .high = 2e4,
         .help = "height above which woods grow",
         .example = "300",
         .absent = "no limit"},
        needs_woods_by_rules},
       {path(wood, &Canopy::highest_m),
        {.key = "highest_m",
         .unit = "m",
         .low = -2e4,
         .high = 2e4,
         .help = "height below which woods grow",
         .example = "1700",
         .absent = "the tree line"},
        needs_woods_by_rules},
       {path(wood, &Canopy::edge_m),
        {.key = "edge_m",
         .unit = "m",
         .low = 0.01,
         .high = 2000.0,
         .help = "difference of height over which woods end at these heights"},
        needs_woods_by_rules},
       {path(wood, &Canopy::steepest_rad),
        {.key = "steepest_deg",
         .unit = "deg",
         .low = 0.0,
         .high = 90.0,
         .help = "slope below which woods grow, from level",
         .scale = radians_per_degree},
        needs_woods_by_rules},
       {path(wood, &Canopy::height_m),
        {.key = "height_m", .unit = "m", .low = 2.0, .high = 60.0, .help = "height of the highest crowns"},
        needs_woods},
       {path(wood, &Canopy::colour),
        {.key = "colour",
         .low = 0.0,
         .high = 1.0,
         .help = "mean share of red, green and blue light that crowns reflect, linear Rec.709"},
        needs_woods}});
}

}  // namespace offing::scene
