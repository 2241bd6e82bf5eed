#include <utility>

#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;

constexpr auto singles = &Scene::clouds;
constexpr auto layers = &Scene::cloud_layers;
constexpr auto common = &Scene::cloud_settings;
constexpr std::size_t max_clouds = 4096, max_layers = 64, max_levels = 6;
constexpr std::size_t max_balls = 16'384;  // the editor writes out those of a genus: a cirrus has some 5000
constexpr double farthest_m = 1e7, highest_m = 50e3;

std::vector<std::string_view> genera() {
  return {"cirrus",      "stratus",      "cumulus",    "stratocumulus",
          "altocumulus", "cumulonimbus", "lenticular", "funnel"};
}

std::vector<Parameter> common_rows() {
  return {
      {.key = "clouds.light",
       .group = ParameterGroup::clouds,
       .storage = choice<common, &CloudsScene::light>({"harris", "calibrated"}),
       .help = "how light goes through them: as Harris has it, or corrected to keep energy"},
      {.key = "clouds.seed",
       .group = ParameterGroup::clouds,
       .storage = &member<common, &CloudsScene::seed>,
       .high = 9223372036854775807.0,
       .help = "number that picks one sky among all of the same clouds"},
      {.key = "clouds.quality",
       .group = ParameterGroup::clouds,
       .storage = &member<common, &CloudsScene::quality>,
       .low = 0.01,
       .high = 100.0,
       .help = "particles, in those that clouds ask for; the last children of grown ones are larger instead",
       .slider = {{0.01, 10.0}}},
      {.key = "clouds.light_step_s",
       .group = ParameterGroup::clouds,
       .storage = &member<common, &CloudsScene::light_step_s>,
       .unit = "s",
       .low = 0.0,
       .high = 60.0,
       .help = "their light and shadows are worked out at multiples of this time and drift with them; 0: at "
               "each picture"},
      {.key = "clouds.shadows",
       .group = ParameterGroup::clouds,
       .storage = choice<common, &CloudsScene::shadows>({"off", "on"}),
       .help = "whether they throw shadows on sea, ground and meshes"},
      {.key = "clouds.crisp_puffs",
       .group = ParameterGroup::clouds,
       .storage = &member<common, &CloudsScene::crisp_billboards>,
       .help = "a folder of 16 PNG pictures, the textures of heaps",
       .example = "puffs",
       .absent = "those of Offing",
       .rule = ParameterRule::file_name},
      {.key = "clouds.soft_puffs",
       .group = ParameterGroup::clouds,
       .storage = &member<common, &CloudsScene::soft_billboards>,
       .help = "the same for sheets and streaks",
       .example = "wisps",
       .absent = "those of Offing",
       .rule = ParameterRule::file_name}};
}

std::vector<Parameter> layer_rows() {
  return rows_of_section(
      section_of_list<layers>, ParameterGroup::cloud_layer, max_layers,
      {{.key = "cloud_layer.genus",
        .storage = choice_at<&element<layers, &CloudLayerScene::genus>>(genera()),
        .help = "what its clouds are"},
       {.key = "cloud_layer.coverage",
        .storage = &element<layers, &CloudLayerScene::coverage>,
        .low = 0.0,
        .high = 0.95,
        .help = "share of the sky that they cover, seen from above; chance leaves gaps in fuller ones"},
       {.key = "cloud_layer.extent_m",
        .storage = &element<layers, &CloudLayerScene::extent_m>,
        .unit = "m",
        .low = 100.0,
        .high = 1e6,
        .help = "edge of the square that they are scattered over",
        .slider = {{100.0, 1e5}}},
       {.key = "cloud_layer.x_m",
        .storage = &element<layers, &CloudLayerScene::x_m>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "its middle, east of the origin"},
       {.key = "cloud_layer.y_m",
        .storage = &element<layers, &CloudLayerScene::altitude_m>,
        .unit = "m",
        .low = 0.0,
        .high = highest_m,
        .help = "altitude of the clouds, above the sea",
        .example = "1200",
        .absent = "that of the genus"},
       {.key = "cloud_layer.z_m",
        .storage = &element<layers, &CloudLayerScene::z_m>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "its middle, south of the origin"},
       {.key = "cloud_layer.seed",
        .storage = &element<layers, &CloudLayerScene::seed>,
        .high = 9223372036854775807.0,
        .help = "number that picks one among all layers of the same values, beside that of [clouds]"}});
}

std::vector<Parameter> in_clouds(std::vector<Parameter> rows) {
  return rows_of_section(section_of_list<singles>, ParameterGroup::cloud, max_clouds, std::move(rows));
}

std::vector<Parameter> place_rows() {
  constexpr auto position = &CloudScene::position_m;
  return in_clouds(
      {{.key = "cloud.name",
        .storage = &element<singles, &CloudScene::name>,
        .help = "for messages and panels",
        .example = "anvil",
        .absent = "none",
        .rule = ParameterRule::name},
       {.key = "cloud.genus",
        .storage = choice_at<&element<singles, &CloudScene::genus>>(genera()),
        .help = "what all that is not given comes from"},
       {.key = "cloud.x_m",
        .storage = &element<singles, position, &glm::dvec3::x>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "where its middle is, east of the origin; with keys it follows them, not the wind",
        .motion = keyed},
       {.key = "cloud.y_m",
        .storage = &element<singles, &CloudScene::altitude_m>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "above the sea",
        .example = "1200",
        .absent = "the altitude of its genus",
        .motion = keyed},
       {.key = "cloud.z_m",
        .storage = &element<singles, position, &glm::dvec3::z>,
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "south of the origin",
        .motion = keyed},
       {.key = "cloud.scale",
        .storage = &element<singles, &CloudScene::scale>,
        .low = 1e-3,
        .high = 1e3,
        .help = "of all lengths of its form, about its middle"},
       {.key = "cloud.seed",
        .storage = &element<singles, &CloudScene::seed>,
        .high = 9223372036854775807.0,
        .help = "number that picks one among all clouds of the same form, beside that of [clouds]"}});
}

std::vector<Parameter> modelling_rows() {
  return in_clouds(
      {{.key = "cloud.modelling",
        .storage =
            choice_at<&element<singles, &CloudScene::modelling>>({"as_genus", "sampled", "hierarchical"}),
        .help = "particles sampled from the density of its balls, or grown on balls as on seeds",
        .use = ParameterUse::balled_cloud},
       {.key = "cloud.sampling",
        .storage = choice_at<&element<singles, &CloudScene::sampling>>({"as_genus", "uniform", "random"}),
        .help = "where the density of a sampled cloud is read: on a grid and merged, or at random places",
        .use = ParameterUse::sampled_cloud},
       {.key = "cloud.target_particles",
        .storage = &element<singles, &CloudScene::target_particles>,
        .high = 1e7,
        .help = "about how many a sampled cloud gets, 0: as its genus",
        .use = ParameterUse::sampled_cloud},
       {.key = "cloud.base_m",
        .storage = &element<singles, &CloudScene::base_m>,
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "height below which a hierarchical cloud is pressed flat, above its middle",
        .example = "-100",
        .absent = "as its genus",
        .use = ParameterUse::grown_cloud}});
}

/// Rows that matter to some clouds only.
std::vector<Parameter> used_by(ParameterUse use, std::vector<Parameter> rows) {
  for (Parameter& row : rows) row.use = use;
  return rows;
}

std::vector<Parameter> ball_rows() {
  using clouds::Metaball;
  constexpr auto list = &CloudScene::balls;
  constexpr auto centre = &Metaball::centre_m;
  std::vector<Parameter> rows;
  constexpr ValueAt<double> places[]{&inner_element<singles, list, centre, &glm::dvec3::x>,
                                     &inner_element<singles, list, centre, &glm::dvec3::y>,
                                     &inner_element<singles, list, centre, &glm::dvec3::z>};
  constexpr std::string_view keys[]{"cloud.ball.x_m", "cloud.ball.y_m", "cloud.ball.z_m"};
  constexpr std::string_view helps[]{"its middle, east of the cloud's", "above the cloud's",
                                     "south of the cloud's"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.push_back({.key = keys[axis],
                    .storage = places[axis],
                    .unit = "m",
                    .low = -1e6,
                    .high = 1e6,
                    .help = helps[axis]});
  }
  rows.push_back({.key = "cloud.ball.radius_m",
                  .storage = &inner_element<singles, list, &Metaball::radius_m>,
                  .unit = "m",
                  .low = 1e-3,
                  .high = 1e6,
                  .help = "where its density ends"});
  rows.push_back({.key = "cloud.ball.weight",
                  .storage = &inner_element<singles, list, &Metaball::weight>,
                  .low = 0.0,
                  .high = 1e4,
                  .help = "density in its middle"});
  return used_by(ParameterUse::balled_cloud,
                 rows_of_section(section_of_inner_list<singles, list>, ParameterGroup::cloud_ball, max_balls,
                                 std::move(rows)));
}

std::vector<Parameter> level_rows() {
  using clouds::HierarchyLevel;
  constexpr auto list = &CloudScene::levels;
  return used_by(
      ParameterUse::grown_cloud,
      rows_of_section(section_of_inner_list<singles, list>, ParameterGroup::cloud_level, max_levels,
                      {{.key = "cloud.level.ratio",
                        .storage = &inner_element<singles, list, &HierarchyLevel::ratio>,
                        .low = 0.02,
                        .high = 1.0,
                        .help = "radius of its particles, in those of the level above"},
                       {.key = "cloud.level.deviation_m",
                        .storage = &inner_element<singles, list, &HierarchyLevel::deviation_m>,
                        .unit = "m",
                        .low = 0.0,
                        .high = 1e6,
                        .help = "added to the radius above by chance, up to this much"},
                       {.key = "cloud.level.repulsion",
                        .storage = &inner_element<singles, list, &HierarchyLevel::repulsion>,
                        .low = 0.05,
                        .high = 20.0,
                        .help = "spacing in drawn radii: above 1 they stand apart, below they overlap"}}));
}

}  // namespace

std::vector<Parameter> cloud_parameters() {
  std::vector<Parameter> rows;
  for (const std::vector<Parameter>& more :
       {common_rows(), layer_rows(), place_rows(), modelling_rows(), cloud_shape_parameters(), ball_rows(),
        level_rows(), particle_edit_parameters()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace offing::scene
