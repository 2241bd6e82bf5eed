#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "host/mesh_shapes/shape_table.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;

constexpr auto material = &MeshScene::material;
constexpr std::size_t max_highlights = 256;
/// Of BaseShading.
constexpr std::array<std::string_view, 4> shading_names{"phong", "gouraud", "cartoon", "flat"};

std::string needs_shape(const UseContext&, const MeshScene& mesh) {
  return mesh.file.empty() ? "" : "the mesh comes from " + mesh.file;
}

std::string needs_file(const UseContext&, const MeshScene& mesh) {
  return mesh.file.empty() ? "the mesh is a shape, which does not deform" : "";
}

std::string needs_sequence(const UseContext&, const MeshScene& mesh) {
  return mesh.file.find('%') == std::string::npos ? "the file is not a sequence of meshes" : "";
}

std::string needs_cartoon(const UseContext&, const MeshScene& mesh) {
  if (mesh.material.shading == world::BaseShading::cartoon) return "";
  return fmt::format("the shading is {}", shading_names[static_cast<std::size_t>(mesh.material.shading)]);
}

std::string needs_steps(const UseContext& context, const MeshScene& mesh) {
  return mesh.cartoon_ramp.empty() ? needs_cartoon(context, mesh) : "mesh.cartoon_ramp is given";
}

/// Whether a value is 0, and at all times: what moves may be there at another one.
bool is_never(const UseContext& context, const char* key, double value) {
  return value == 0.0 && !context.scene.tracks.contains({key, context.element});
}

std::string needs_outline(const UseContext& context, const MeshScene& mesh) {
  return is_never(context, "mesh.outline_px", mesh.material.outline_px) ? "the mesh has no outline" : "";
}

std::string needs_specular(const UseContext& context, const MeshScene& mesh) {
  return is_never(context, "mesh.specular", mesh.material.specular) ? "mesh.specular is 0" : "";
}

std::string needs_highlights(const UseContext&, const MeshScene& mesh) {
  return mesh.shown == MeshHighlights::on ? "" : "the mesh's highlights are off";
}

std::string needs_no_cap(const UseContext& context, const MeshScene& mesh) {
  return mesh.cap_radius_m ? "mesh.cap_radius_m is given" : needs_highlights(context, mesh);
}

std::vector<Row<MeshScene>> mesh_form_rows() {
  static const std::string size_help = "size of a shape: " + mesh_shapes::meaning_of_size();
  return {{&MeshScene::name,
           {.key = "name",
            .affects = Affects::mesh_looks,
            .help = "name in messages and panels",
            .example = "knot",
            .absent = "none",
            .rule = ParameterRule::name}},
          {&MeshScene::file,
           {.key = "file",
            .help = "OBJ, PLY, OFF, STL or glTF in metres, +y up. A PLY of `offing-mesh curvature` brings "
                    "its curvatures; for other files the device computes them. frames/mesh_%04d.ply is a "
                    "sequence of meshes; the first is at 0 s",
            .example = "head.ply",
            .absent = "none: uses shape",
            .rule = ParameterRule::file_name}},
          {&MeshScene::animation,
           {.key = "animation",
            .help = "name of the glTF animation that deforms the mesh",
            .example = "walk",
            .absent = "all; the first one that moves a value counts",
            .rule = ParameterRule::name},
           needs_file},
          {choice(&MeshScene::repeats, {"off", "on"}),
           {.key = "animation_repeat", .help = "whether the file's animation repeats"},
           needs_file},
          {&MeshScene::sequence_frames_per_s,
           {.key = "sequence_fps",
            .low = 0.01,
            .high = 1000.0,
            .help = "meshes per second of a sequence such as frames/mesh_%04d.ply"},
           needs_sequence},
          {choice(&MeshScene::shape, mesh_shapes::names_of(mesh_shapes::shapes())),
           {.key = "shape", .help = "shape to generate, if no file is given"},
           needs_shape},
          {&MeshScene::size_m,
           {.key = "size_m",
            .unit = "m",
            .low = mesh_shapes::smallest_size_m,
            .high = mesh_shapes::largest_size_m,
            .help = size_help},
           needs_shape},
          {&MeshScene::detail,
           {.key = "detail",
            .low = 0.0,
            .high = 5.0,
            .help = "fineness of a shape: each step has four times the faces; at 2 a knot has 2,880"},
           needs_shape},
          {&MeshScene::scale,
           {.key = "scale",
            .low = 1e-6,
            .high = 1e6,
            .help = "factor on the size of the mesh, about its origin: 0.001 for a file in millimetres"}},
          {&MeshScene::smoothing_rounds,
           {.key = "smoothing_rounds",
            .low = 0.0,
            .high = 1000.0,
            .help = "rounds in which normals are averaged with their neighbours; gives fewer highlights on "
                    "noisy scans"}}};
}

std::vector<Row<MeshScene>> place_rows() {
  constexpr auto place = &MeshScene::position_m;
  return {{path(place, &glm::dvec3::x),
           {.key = "x_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "position of the mesh's origin, east of the scene's",
            .motion = keyed}},
          {path(place, &glm::dvec3::y),
           {.key = "y_m",
            .unit = "m",
            .low = -1e5,
            .high = 1e5,
            .help = "height of its origin, from the same zero as terrain heights",
            .motion = keyed}},
          {path(place, &glm::dvec3::z),
           {.key = "z_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "position of its origin, south of the scene's",
            .motion = keyed}},
          {&MeshScene::yaw_rad,
           {.key = "yaw_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "turn clockwise, seen from above",
            .scale = radians_per_degree,
            .motion = keyed_angle}},
          {&MeshScene::pitch_rad,
           {.key = "pitch_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "turn about its own x axis, which raises its -z side",
            .scale = radians_per_degree,
            .motion = keyed_angle}},
          {&MeshScene::roll_rad,
           {.key = "roll_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "turn about its own z axis, which lowers its +x side; applied first",
            .scale = radians_per_degree,
            .motion = keyed_angle}},
          {&MeshScene::spin_radps,
           {.key = "spin_deg_per_s",
            .unit = "deg/s",
            .low = -3600.0,
            .high = 3600.0,
            .help = "how fast its yaw increases from time 0 on",
            .scale = radians_per_degree}},
          {&MeshScene::aboard,
           {.key = "aboard",
            .help = "name of a body that carries it. Position and turns are then relative to the body: "
                    "bow +x, up +y, starboard +z",
            .example = "ship",
            .absent = "none: it is placed in the world",
            .rule = ParameterRule::name}}};
}

std::vector<Row<MeshScene>> mesh_look_rows() {
  using world::MeshMaterial;
  return {
      {choice(path(material, &MeshMaterial::visible), {"off", "on"}),
       {.key = "visible",
        .help = "whether it is drawn; a body whose hull is not drawn floats and makes waves all the same"}},
      {choice(path(material, &MeshMaterial::shading), {shading_names.begin(), shading_names.end()}),
       {.key = "shading",
        .help = "shade per pixel (phong), per vertex (gouraud), in steps (cartoon) or per face (flat)"}},
      {path(material, &MeshMaterial::colour),
       {.key = "colour",
        .low = 0.0,
        .high = 1.0,
        .help = "share of red, green and blue light that it reflects, linear Rec.709",
        .motion = keyed}},
      {path(material, &MeshMaterial::specular),
       {.key = "specular",
        .low = 0.0,
        .high = 1.0,
        .help = "strength of a plain Blinn highlight, in addition to those that can be shaped",
        .motion = keyed}},
      {path(material, &MeshMaterial::shininess),
       {.key = "shininess",
        .low = 1.0,
        .high = 10000.0,
        .help = "exponent of the plain Blinn highlight",
        .motion = keyed},
       needs_specular},
      {path(material, &MeshMaterial::cartoon_steps),
       {.key = "cartoon_steps",
        .low = 1.0,
        .high = 16.0,
        .help = "number of light steps, for shading = \"cartoon\""},
       needs_steps},
      {&MeshScene::cartoon_ramp,
       {.key = "cartoon_ramp",
        .help = "PNG whose middle row replaces the steps, for shading = \"cartoon\". Its left end is for "
                "surfaces that the light grazes, its right end for surfaces that face it",
        .example = "ramp.png",
        .absent = "none: equal steps",
        .rule = ParameterRule::file_name},
       needs_cartoon},
      {path(material, &MeshMaterial::outline_px),
       {.key = "outline_px",
        .low = 0.0,
        .high = 32.0,
        .help = "width of the outline around the mesh; 0: none",
        .motion = keyed}},
      {path(material, &MeshMaterial::outline_colour),
       {.key = "outline_colour",
        .low = 0.0,
        .high = 1.0,
        .help = "colour of the outline, linear Rec.709",
        .motion = keyed},
       needs_outline}};
}

std::vector<Row<MeshScene>> highlight_rows() {
  return {{choice(&MeshScene::shown, {"off", "on"}),
           {.key = "highlights", .help = "whether to find and draw highlights"}},
          {&MeshScene::threshold,
           {.key = "threshold",
            .low = 0.01,
            .high = 0.9999,
            .help = "N.H at the edge of a highlight; larger values make highlights smaller"},
           needs_highlights},
          {&MeshScene::cap_radius_m,
           {.key = "cap_radius_m",
            .unit = "m",
            .low = 1e-6,
            .high = 1e5,
            .help = "largest half width of a highlight, which limits highlights on flat places",
            .example = "0.2",
            .absent = "none: uses flat_limit"},
           needs_highlights},
          {choice(&MeshScene::flat_limit, {"surface", "edges"}),
           {.key = "flat_limit",
            .help = "what limits highlights on flat places: the bend of the surface around them, or three "
                    "mean edge lengths of the mesh"},
           needs_no_cap}};
}

}  // namespace

Schema<MeshScene> mesh_schema() {
  Schema<MeshScene> schema("mesh");
  return schema.rows(ParameterGroup::mesh, Affects::meshes, mesh_form_rows())
      .rows(ParameterGroup::mesh, Affects::meshes, place_rows())
      .rows(ParameterGroup::mesh, Affects::mesh_looks, mesh_look_rows())
      .rows(ParameterGroup::mesh, Affects::meshes, highlight_rows())
      .list(&MeshScene::highlights, max_highlights, highlight_schema());
}

}  // namespace offing::scene
