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
  return cloud.shape.file.ends_with(".ply") ? "cloud.file has its particles" : "";
}

std::vector<std::string_view> genera() {
  return {"cirrus",      "stratus",      "cumulus",    "stratocumulus",
          "altocumulus", "cumulonimbus", "lenticular", "funnel"};
}

std::vector<Row<CloudsScene>> common_rows() {
  return {
      {choice(&CloudsScene::light, {"harris", "calibrated"}),
       {.key = "light",
        .help = "how light goes through them: as Harris has it, or corrected to keep energy"}},
      {&CloudsScene::seed,
       {.key = "seed",
        .high = 9223372036854775807.0,
        .help = "number that picks one sky among all of the same clouds"}},
      {&CloudsScene::quality,
       {.key = "quality",
        .low = 0.01,
        .high = 100.0,
        .help = "particles, in those that clouds ask for; the last children of grown ones are larger instead",
        .slider = {{0.01, 10.0}}}},
      {&CloudsScene::light_step_s,
       {.key = "light_step_s",
        .unit = "s",
        .low = 0.0,
        .high = 60.0,
        .help = "their light and shadows are worked out at multiples of this time and drift with them; 0: at "
                "each picture"}},
      {choice(&CloudsScene::shadows, {"off", "on"}),
       {.key = "shadows", .help = "whether they throw shadows on sea, ground and meshes"}},
      {&CloudsScene::crisp_billboards,
       {.key = "crisp_billboards",
        .alias = "crisp_puffs",
        .help = "a folder of 16 PNG pictures, the textures of heaps",
        .example = "heaps",
        .absent = "those of Offing",
        .rule = ParameterRule::file_name}},
      {&CloudsScene::soft_billboards,
       {.key = "soft_billboards",
        .alias = "soft_puffs",
        .help = "the same for sheets and streaks",
        .example = "wisps",
        .absent = "those of Offing",
        .rule = ParameterRule::file_name}}};
}

std::vector<Row<CloudLayerScene>> layer_rows() {
  return {{choice(&CloudLayerScene::genus, genera()), {.key = "genus", .help = "what its clouds are"}},
          {&CloudLayerScene::coverage,
           {.key = "coverage",
            .low = 0.0,
            .high = 0.95,
            .help = "share of the sky that they cover, seen from above; chance leaves gaps in fuller ones"}},
          {&CloudLayerScene::extent_m,
           {.key = "extent_m",
            .unit = "m",
            .low = 100.0,
            .high = 1e6,
            .help = "edge of the square that they are scattered over",
            .slider = {{100.0, 1e5}}}},
          {&CloudLayerScene::x_m,
           {.key = "x_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "its middle, east of the origin"}},
          {&CloudLayerScene::altitude_m,
           {.key = "y_m",
            .unit = "m",
            .low = 0.0,
            .high = highest_m,
            .help = "altitude of the clouds, above the sea",
            .example = "1200",
            .absent = "that of the genus"}},
          {&CloudLayerScene::z_m,
           {.key = "z_m",
            .unit = "m",
            .low = -farthest_m,
            .high = farthest_m,
            .help = "its middle, south of the origin"}},
          {&CloudLayerScene::seed,
           {.key = "seed",
            .high = 9223372036854775807.0,
            .help = "number that picks one among all layers of the same values, beside that of [clouds]"}}};
}

std::vector<Row<CloudScene>> place_rows() {
  constexpr auto position = &CloudScene::position_m;
  return {
      {&CloudScene::name,
       {.key = "name",
        .help = "for messages and panels",
        .example = "anvil",
        .absent = "none",
        .rule = ParameterRule::name}},
      {choice(&CloudScene::genus, genera()),
       {.key = "genus", .help = "what all that is not given comes from"}},
      {path(position, &glm::dvec3::x),
       {.key = "x_m",
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "where its middle is, east of the origin; with keys it follows them, not the wind",
        .motion = keyed}},
      {&CloudScene::altitude_m,
       {.key = "y_m",
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "above the sea",
        .example = "1200",
        .absent = "the altitude of its genus",
        .motion = keyed}},
      {path(position, &glm::dvec3::z),
       {.key = "z_m",
        .unit = "m",
        .low = -farthest_m,
        .high = farthest_m,
        .help = "south of the origin",
        .motion = keyed}},
      {&CloudScene::scale,
       {.key = "scale", .low = 1e-3, .high = 1e3, .help = "of all lengths of its form, about its middle"}},
      {&CloudScene::seed,
       {.key = "seed",
        .high = 9223372036854775807.0,
        .help = "number that picks one among all clouds of the same form, beside that of [clouds]"}}};
}

std::vector<Row<CloudScene>> modelling_rows() {
  return {
      {choice_or("as_genus", &CloudScene::modelling, {"sampled", "hierarchical"}),
       {.key = "modelling",
        .help = "particles sampled from the density of its balls, or grown on balls as on seeds"},
       needs_balls},
      {choice_or("as_genus", &CloudScene::sampling, {"uniform", "random"}),
       {.key = "sampling",
        .help = "where the density of a sampled cloud is read: on a grid and merged, or at random places"},
       needs_sampling},
      {&CloudScene::target_particles,
       {.key = "target_particles",
        .high = 1e7,
        .help = "about how many a sampled cloud gets, 0: as its genus"},
       needs_sampling},
      {&CloudScene::base_m,
       {.key = "base_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "height below which a hierarchical cloud is pressed flat, above its middle",
        .example = "-100",
        .absent = "as its genus"},
       needs_growth}};
}

std::vector<Row<clouds::Metaball>> ball_rows() {
  using clouds::Metaball;
  constexpr auto centre = &Metaball::centre_m;
  std::vector<Row<Metaball>> rows{
      {path(centre, &glm::dvec3::x), {.key = "x_m", .help = "its middle, east of the cloud's"}, needs_balls},
      {path(centre, &glm::dvec3::y), {.key = "y_m", .help = "above the cloud's"}, needs_balls},
      {path(centre, &glm::dvec3::z), {.key = "z_m", .help = "south of the cloud's"}, needs_balls}};
  for (Row<Metaball>& row : rows) {
    row.facts.unit = "m";
    row.facts.low = -1e6;
    row.facts.high = 1e6;
  }
  rows.push_back(
      {&Metaball::radius_m,
       {.key = "radius_m", .unit = "m", .low = 1e-3, .high = 1e6, .help = "where its density ends"},
       needs_balls});
  rows.push_back({&Metaball::weight,
                  {.key = "weight", .low = 0.0, .high = 1e4, .help = "density in its middle"},
                  needs_balls});
  return rows;
}

std::vector<Row<clouds::HierarchyLevel>> level_rows() {
  using clouds::HierarchyLevel;
  return {{&HierarchyLevel::ratio,
           {.key = "ratio",
            .low = 0.02,
            .high = 1.0,
            .help = "radius of its particles, in those of the level above"},
           needs_growth},
          {&HierarchyLevel::deviation_m,
           {.key = "deviation_m",
            .unit = "m",
            .low = 0.0,
            .high = 1e6,
            .help = "added to the radius above by chance, up to this much"},
           needs_growth},
          {&HierarchyLevel::repulsion,
           {.key = "repulsion",
            .low = 0.05,
            .high = 20.0,
            .help = "spacing in drawn radii: above 1 they stand apart, below they overlap"},
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
  return schema.rows(ParameterGroup::cloud, Affects::clouds, place_rows())
      .rows(ParameterGroup::cloud, Affects::clouds, modelling_rows())
      .rows(ParameterGroup::cloud, Affects::clouds, cloud_shape_rows())
      .list(&CloudScene::balls, max_balls, ball_schema)
      .list(&CloudScene::levels, max_levels, level_schema)
      .list(&CloudScene::edits, max_edits, particle_edit_schema());
}

}  // namespace offing::scene
