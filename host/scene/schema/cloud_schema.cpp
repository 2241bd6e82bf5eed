#include <string>

#include "host/clouds/shape/genera.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;

constexpr std::size_t max_levels = 6, max_edits = 4096;
constexpr std::size_t max_balls = 16'384;  // the editor writes out those of a genus: a cirrus has some 5000
constexpr double farthest_m = 1e7, highest_m = 50e3;

/// The key of what makes a cloud in place of its balls; empty where they do.
std::string shape_key(const CloudShapeScene& shape) {
  if (!shape.file.empty()) return "cloud.file";
  if (!shape.mesh.empty()) return "cloud.mesh";
  if (!shape.text.empty()) return "cloud.text";
  return shape.solid ? "cloud.shape" : "";
}

bool grows(const CloudScene& cloud) {
  return cloud.modelling.value_or(clouds::preset(cloud.genus).modelling) == clouds::Modelling::hierarchical;
}

const CloudScene& cloud_of(const UseContext& context) {
  return context.scene.clouds[context.element.outer];
}

/// Of a [[cloud]], or of a section in it.
template <class Struct>
std::string needs_balls(const UseContext& context, const Struct&) {
  const std::string made_by = shape_key(cloud_of(context).shape);
  return made_by.empty() ? "" : made_by + " makes it";
}

template <class Struct>
std::string needs_growth(const UseContext& context, const Struct& section) {
  const std::string reason = needs_balls(context, section);
  return reason.empty() && !grows(cloud_of(context)) ? "it is sampled" : reason;
}

std::string needs_sampling(const UseContext&, const CloudScene& cloud) {
  if (shape_key(cloud.shape).empty()) return grows(cloud) ? "it grows on its balls" : "";
  return cloud.shape.file.ends_with(".ply") ? "cloud.file contains its particles" : "";
}

std::vector<std::string_view> genera() {
  return {"cirrus",      "stratus",      "cumulus",    "stratocumulus",
          "altocumulus", "cumulonimbus", "lenticular", "funnel"};
}

std::vector<Row<CloudsScene>> common_rows() {
  return {{choice(&CloudsScene::light, {"harris", "calibrated"}),
           {.key = "light", .help = "light model: as Harris published it, or calibrated to conserve energy"}},
          {&CloudsScene::seed,
           {.key = "seed",
            .high = 9223372036854775807.0,
            .help = "random seed: another seed gives other clouds of the same kind"}},
          {&CloudsScene::quality,
           {.key = "quality",
            .low = 0.01,
            .high = 100.0,
            .help = "factor on the number of particles; hierarchical clouds change the size of their "
                    "smallest particles to match",
            .slider = {{0.01, 10.0}}}},
          {&CloudsScene::light_step_s,
           {.key = "light_step_s",
            .unit = "s",
            .low = 0.0,
            .high = 60.0,
            .help = "time between updates of light and shadows, which drift with the clouds in between; 0: "
                    "update for each picture"}},
          {choice(&CloudsScene::shadows, {"off", "on"}),
           {.key = "shadows", .help = "whether they cast shadows on sea, ground and meshes"}},
          {&CloudsScene::crisp_billboards,
           {.key = "crisp_billboards",
            .alias = "crisp_puffs",
            .help = "folder of 16 PNG textures for heaped clouds",
            .example = "heaps",
            .absent = "built in",
            .rule = ParameterRule::file_name}},
          {&CloudsScene::soft_billboards,
           {.key = "soft_billboards",
            .alias = "soft_puffs",
            .help = "folder of 16 PNG textures for sheets and streaks",
            .example = "wisps",
            .absent = "built in",
            .rule = ParameterRule::file_name}}};
}

std::vector<Row<CloudLayerScene>> layer_rows() {
  return {
      {choice(&CloudLayerScene::visible, {"off", "on"}),
       {.key = "visible", .help = "whether its clouds are shown; hidden clouds cast no shadows"}},
      {choice(&CloudLayerScene::genus, genera()), {.key = "genus", .help = "genus of its clouds"}},
      {&CloudLayerScene::coverage,
       {.key = "coverage",
        .low = 0.0,
        .high = 0.95,
        .help =
            "share of the sky that the clouds cover, seen from above; at high coverage chance leaves gaps"}},
      {&CloudLayerScene::extent_m,
       {.key = "extent_m",
        .unit = "m",
        .low = 100.0,
        .high = 1e6,
        .help = "side of the square over which the clouds are scattered",
        .slider = {{100.0, 1e5}}}},
      {&CloudLayerScene::x_m,
       {.key = "x_m",
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "middle of the layer, east of the origin"}},
      {&CloudLayerScene::altitude_m,
       {.key = "y_m",
        .unit = "m",
        .low = 0.0,
        .high = highest_m,
        .help = "altitude of the clouds, from the same zero as terrain heights",
        .example = "1200",
        .absent = "set by the genus"}},
      {&CloudLayerScene::z_m,
       {.key = "z_m",
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "middle of the layer, south of the origin"}},
      {&CloudLayerScene::seed,
       {.key = "seed",
        .high = 9223372036854775807.0,
        .help = "random seed of this layer, combined with that of [clouds]"}}};
}

std::vector<Row<CloudScene>> cloud_place_rows() {
  constexpr auto position = &CloudScene::position_m;
  return {{&CloudScene::name,
           {.key = "name",
            .help = "name in messages and panels",
            .example = "anvil",
            .absent = "none",
            .rule = ParameterRule::name}},
          {choice(&CloudScene::visible, {"off", "on"}),
           {.key = "visible", .help = "whether it is shown; a hidden cloud casts no shadow"}},
          {choice(&CloudScene::genus, genera()),
           {.key = "genus", .help = "genus, which sets the default of every other value"}},
          {path(position, &glm::dvec3::x),
           {.key = "x_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "its middle, east of the origin; with keyframes it follows these instead of the wind",
            .motion = keyed}},
          {&CloudScene::altitude_m,
           {.key = "y_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "height of its middle, from the same zero as terrain heights",
            .example = "1200",
            .absent = "set by the genus",
            .motion = keyed}},
          {path(position, &glm::dvec3::z),
           {.key = "z_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "its middle, south of the origin",
            .motion = keyed}},
          {&CloudScene::scale,
           {.key = "scale",
            .low = 1e-3,
            .high = 1e3,
            .help = "factor on all lengths of its form, about its middle"}},
          {&CloudScene::seed,
           {.key = "seed",
            .high = 9223372036854775807.0,
            .help = "random seed of this cloud, combined with that of [clouds]"}}};
}

std::vector<Row<CloudScene>> modelling_rows() {
  return {{choice_or("as_genus", &CloudScene::modelling, {"sampled", "hierarchical"}),
           {.key = "modelling",
            .help = "where particles come from: sampled from the density of its balls, or grown on its balls "
                    "(hierarchical)"},
           needs_balls},
          {choice_or("as_genus", &CloudScene::sampling, {"uniform", "random"}),
           {.key = "sampling",
            .help = "where a sampled cloud reads its density: on a grid whose samples are merged (uniform), "
                    "or at random places"},
           needs_sampling},
          {&CloudScene::target_particles,
           {.key = "target_particles",
            .high = 1e7,
            .help = "approximate number of particles of a sampled cloud; 0: set by the genus"},
           needs_sampling},
          {&CloudScene::base_m,
           {.key = "base_m",
            .unit = "m",
            .low = -1e6,
            .high = 1e6,
            .help = "height above its middle below which a hierarchical cloud is flattened",
            .example = "-100",
            .absent = "set by the genus"},
           needs_growth}};
}

std::vector<Row<clouds::Metaball>> ball_rows() {
  using clouds::Metaball;
  constexpr auto centre = &Metaball::centre_m;
  std::vector<Row<Metaball>> rows{{path(centre, &glm::dvec3::x),
                                   {.key = "x_m", .help = "centre of the ball, east of the cloud's middle"},
                                   needs_balls},
                                  {path(centre, &glm::dvec3::y),
                                   {.key = "y_m", .help = "centre of the ball, above the cloud's middle"},
                                   needs_balls},
                                  {path(centre, &glm::dvec3::z),
                                   {.key = "z_m", .help = "centre of the ball, south of the cloud's middle"},
                                   needs_balls}};
  for (Row<Metaball>& row : rows) {
    row.facts.unit = "m";
    row.facts.low = -1e6;
    row.facts.high = 1e6;
  }
  rows.push_back(
      {&Metaball::radius_m,
       {.key = "radius_m", .unit = "m", .low = 1e-3, .high = 1e6, .help = "radius at which its density ends"},
       needs_balls});
  rows.push_back({&Metaball::weight,
                  {.key = "weight", .low = 0.0, .high = 1e4, .help = "density at its centre"},
                  needs_balls});
  return rows;
}

std::vector<Row<clouds::HierarchyLevel>> level_rows() {
  using clouds::HierarchyLevel;
  return {{&HierarchyLevel::ratio,
           {.key = "ratio",
            .low = 0.02,
            .high = 1.0,
            .help = "radius of its particles, relative to those of the level above"},
           needs_growth},
          {&HierarchyLevel::deviation_m,
           {.key = "deviation_m",
            .unit = "m",
            .low = 0.0,
            .high = 1e6,
            .help = "random length added to the radius of the level above, up to this much"},
           needs_growth},
          {&HierarchyLevel::repulsion,
           {.key = "repulsion",
            .low = 0.05,
            .high = 20.0,
            .help = "spacing of particles in drawn radii: above 1 they stand apart, below 1 they overlap"},
           needs_growth}};
}

}  // namespace

Schema<CloudsScene> clouds_schema() {
  Schema<CloudsScene> schema("clouds");
  return schema.rows(ParameterGroup::clouds, Affects::clouds, common_rows());
}

Schema<CloudLayerScene> cloud_layer_schema() {
  Schema<CloudLayerScene> schema("cloud_layer");
  return schema.rows(ParameterGroup::cloud_layer, Affects::clouds, layer_rows());
}

Schema<CloudScene> cloud_schema() {
  Schema<clouds::Metaball> ball_schema("ball");
  ball_schema.rows(ParameterGroup::cloud_ball, Affects::clouds, ball_rows());
  Schema<clouds::HierarchyLevel> level_schema("level");
  level_schema.rows(ParameterGroup::cloud_level, Affects::clouds, level_rows());
  Schema<CloudScene> schema("cloud");
  return schema.rows(ParameterGroup::cloud, Affects::clouds, cloud_place_rows())
      .rows(ParameterGroup::cloud, Affects::clouds, modelling_rows())
      .rows(ParameterGroup::cloud, Affects::clouds, cloud_shape_rows())
      .list(&CloudScene::balls, max_balls, ball_schema)
      .list(&CloudScene::levels, max_levels, level_schema)
      .list(&CloudScene::edits, max_edits, particle_edit_schema());
}

}  // namespace offing::scene
