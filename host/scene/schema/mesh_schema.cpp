#include <string>

#include "host/mesh_shapes/shape_table.h"
#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;

constexpr auto meshes = &Scene::meshes;
constexpr auto material = &MeshScene::material;
constexpr std::size_t max_meshes = 256;

std::vector<Parameter> in_meshes(std::vector<Parameter> rows) {
  return rows_of_section(section_of_list<meshes>, ParameterGroup::mesh, max_meshes, std::move(rows));
}

std::vector<Parameter> form_rows() {
  static const std::string size_help = "for a shape: " + mesh_shapes::meaning_of_size();
  return in_meshes(
      {{.key = "mesh.name",
        .storage = &element<meshes, &MeshScene::name>,
        .help = "for messages and panels",
        .example = "knot",
        .absent = "none",
        .rule = ParameterRule::name},
       {.key = "mesh.file",
        .storage = &element<meshes, &MeshScene::file>,
        .help = "OBJ, PLY, OFF, STL or glTF in metres, +y up; a PLY that offing-mesh curvature has prepared "
                "brings its curvatures, for others they are found on the device",
        .example = "head.ply",
        .absent = "none: the shape",
        .rule = ParameterRule::file_name},
       {.key = "mesh.shape",
        .storage =
            choice_at<&element<meshes, &MeshScene::shape>>(mesh_shapes::names_of(mesh_shapes::shapes())),
        .help = "made by a formula",
        .use = ParameterUse::made_mesh},
       {.key = "mesh.size_m",
        .storage = &element<meshes, &MeshScene::size_m>,
        .unit = "m",
        .low = 1e-3,
        .high = 1e5,
        .help = size_help,
        .use = ParameterUse::made_mesh},
       {.key = "mesh.detail",
        .storage = &element<meshes, &MeshScene::detail>,
        .low = 0.0,
        .high = 5.0,
        .help = "how fine a shape is: each step has four times the faces, at 2 a knot has 2,880",
        .use = ParameterUse::made_mesh},
       {.key = "mesh.scale",
        .storage = &element<meshes, &MeshScene::scale>,
        .low = 1e-6,
        .high = 1e6,
        .help =
            "of the mesh about its origin, before it is put in its place: 0.001 for a file in millimetres"},
       {.key = "mesh.smoothing_rounds",
        .storage = &element<meshes, &MeshScene::smoothing_rounds>,
        .low = 0.0,
        .high = 1000.0,
        .help = "how often normals become the mean of those around: fewer highlights on noisy scans"}});
}

std::vector<Parameter> place_rows() {
  constexpr auto place = &MeshScene::position_m;
  return in_meshes(
      {{.key = "mesh.x_m",
        .storage = &element<meshes, place, &glm::dvec3::x>,
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "where the mesh's origin is, east of the scene's",
        .motion = keyed},
       {.key = "mesh.y_m",
        .storage = &element<meshes, place, &glm::dvec3::y>,
        .unit = "m",
        .low = -1e5,
        .high = 1e5,
        .help = "above the mean water level",
        .motion = keyed},
       {.key = "mesh.z_m",
        .storage = &element<meshes, place, &glm::dvec3::z>,
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "south of the scene's origin",
        .motion = keyed},
       {.key = "mesh.yaw_deg",
        .storage = &element<meshes, &MeshScene::yaw_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turned clockwise, seen from above",
        .scale = radians_per_degree,
        .motion = keyed_angle},
       {.key = "mesh.pitch_deg",
        .storage = &element<meshes, &MeshScene::pitch_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turned about its own x axis, its -z side up",
        .scale = radians_per_degree,
        .motion = keyed_angle},
       {.key = "mesh.roll_deg",
        .storage = &element<meshes, &MeshScene::roll_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turned about its own z axis first of all, its +x side down",
        .scale = radians_per_degree,
        .motion = keyed_angle},
       {.key = "mesh.spin_deg_per_s",
        .storage = &element<meshes, &MeshScene::spin_radps>,
        .unit = "deg/s",
        .low = -3600.0,
        .high = 3600.0,
        .help = "how fast its yaw grows from time 0 on",
        .scale = radians_per_degree},
       {.key = "mesh.aboard",
        .storage = &element<meshes, &MeshScene::aboard>,
        .help = "name of a [[body]] that carries it: place and turn are on its hull then, bow +x, "
                "up +y, starboard +z",
        .example = "ship",
        .absent = "none: it stands in the world",
        .rule = ParameterRule::name}});
}

std::vector<Parameter> look_rows() {
  using world::MeshMaterial;
  return in_meshes(
      {{.key = "mesh.shading",
        .storage = choice_at<&element<meshes, material, &MeshMaterial::shading>>(
            {"phong", "gouraud", "cartoon", "flat"}),
        .help = "light a pixel, a vertex, in steps, or a face"},
       {.key = "mesh.colour",
        .storage = &element<meshes, material, &MeshMaterial::colour>,
        .low = 0.0,
        .high = 1.0,
        .help = "share of red, green and blue light that it sends back, linear Rec.709",
        .motion = keyed},
       {.key = "mesh.specular",
        .storage = &element<meshes, material, &MeshMaterial::specular>,
        .low = 0.0,
        .high = 1.0,
        .help = "of a plain highlight (Blinn's) beside the ones of [[mesh.highlight]]",
        .motion = keyed},
       {.key = "mesh.shininess",
        .storage = &element<meshes, material, &MeshMaterial::shininess>,
        .low = 1.0,
        .high = 10000.0,
        .help = "exponent of the plain highlight",
        .use = ParameterUse::shiny_mesh,
        .motion = keyed},
       {.key = "mesh.cartoon_steps",
        .storage = &element<meshes, material, &MeshMaterial::cartoon_steps>,
        .low = 1.0,
        .high = 16.0,
        .help = "of light, for shading = \"cartoon\"",
        .use = ParameterUse::stepped_mesh},
       {.key = "mesh.cartoon_ramp",
        .storage = &element<meshes, &MeshScene::cartoon_ramp>,
        .help = "PNG whose middle row gives the light in place of steps, for shading = \"cartoon\": "
                "that of a surface that lights graze at its left, of one that faces them at its right",
        .example = "ramp.png",
        .absent = "none: equal steps",
        .rule = ParameterRule::file_name,
        .use = ParameterUse::cartoon_mesh},
       {.key = "mesh.outline_px",
        .storage = &element<meshes, material, &MeshMaterial::outline_px>,
        .low = 0.0,
        .high = 32.0,
        .help = "width of a line around the mesh",
        .motion = keyed},
       {.key = "mesh.outline_colour",
        .storage = &element<meshes, material, &MeshMaterial::outline_colour>,
        .low = 0.0,
        .high = 1.0,
        .help = "of that line, linear Rec.709",
        .use = ParameterUse::outlined_mesh,
        .motion = keyed}});
}

std::vector<Parameter> highlight_rows() {
  return in_meshes({{.key = "mesh.highlights",
                     .storage = choice_at<&element<meshes, &MeshScene::shown>>({"off", "on"}),
                     .help = "whether highlights are found and drawn"},
                    {.key = "mesh.threshold",
                     .storage = &element<meshes, &MeshScene::threshold>,
                     .low = 0.01,
                     .high = 0.9999,
                     .help = "N.H at the rim of a highlight: the larger, the smaller the highlights",
                     .use = ParameterUse::found_highlights},
                    {.key = "mesh.cap_radius_m",
                     .storage = &element<meshes, &MeshScene::cap_radius_m>,
                     .unit = "m",
                     .low = 1e-6,
                     .high = 1e5,
                     .help = "largest half width of a highlight, for flat places",
                     .example = "0.2",
                     .absent = "three mean edges of the mesh",
                     .use = ParameterUse::found_highlights}});
}

}  // namespace

std::vector<Parameter> mesh_parameters() {
  std::vector<Parameter> rows;
  for (const std::vector<Parameter>& more : {form_rows(), place_rows(), look_rows(), highlight_rows()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace offing::scene
