#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;

std::string needs_density(const UseContext&, const BodyScene& body) {
  if (body.draught_m) return "body.draught_m is given";
  return body.mass_kg ? "body.mass_kg is given" : "";
}

std::string needs_forces(const UseContext&, const BodyScene& body) {
  return body.motion == BodyMotion::forces ? "" : "the body follows its path";
}

std::vector<Row<BodyScene>> load_rows() {
  return {
      {&BodyScene::name,
       {.key = "name",
        .help = "for messages and for ocean.wake.body",
        .example = "ship",
        .absent = "none",
        .rule = ParameterRule::name}},
      {&BodyScene::mesh,
       {.key = "mesh",
        .help = "name of the [[mesh]] that floats: closed, its faces turned outward; place and turn of that "
                "mesh are within the body then, whose bow is +x, whose top +y",
        .example = "hull",
        .absent = "the first mesh",
        .rule = ParameterRule::name}},
      {&BodyScene::draught_m,
       {.key = "draught_m",
        .unit = "m",
        .low = 1e-4,
        .high = 1e4,
        .help = "how deep its lowest place is below still water while it floats upright; gives its mass",
        .example = "1.8",
        .absent = "that of its mass"}},
      {&BodyScene::mass_kg,
       {.key = "mass_kg",
        .unit = "kg",
        .low = 1e-3,
        .high = 1e12,
        .help = "with all that it carries",
        .example = "80000",
        .absent = "that of its draught or density",
        .instead_of = "draught_m"}},
      {&BodyScene::density_kgpm3,
       {.key = "density_kgpm3",
        .unit = "kg/m3",
        .low = 1.0,
        .high = 1020.0,
        .help = "of all that its hull encloses, in sea water of 1025 kg/m3"},
       needs_density},
      {&BodyScene::mass_centre_m,
       {.key = "mass_centre_m",
        .unit = "m",
        .low = -1e4,
        .high = 1e4,
        .help = "its centre of gravity, forward, up and to starboard of the origin of its hull",
        .example = "[0, 0.2, 0]",
        .absent = "above its centre of buoyancy by a quarter of its draught"}},
      {&BodyScene::hull_faces,
       {.key = "hull_faces",
        .low = 20.0,
        .high = 100000.0,
        .help =
            "most faces that water presses on: a finer mesh floats as a coarser one of the same volume"}}};
}

std::vector<Row<BodyScene>> body_motion_rows() {
  return {
      {choice(&BodyScene::motion, {"forces", "path"}),
       {.key = "motion",
        .help = "what moves it over the water: thrust, rudder and waves from its start on, or x_m, z_m, "
                "heading_deg and speed_mps at any time; it heaves, pitches and rolls either way"}},
      {&BodyScene::x_m,
       {.key = "x_m",
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "its centre of gravity at time 0, east of the origin; keyframes for a path",
        .motion = keyed}},
      {&BodyScene::z_m,
       {.key = "z_m", .unit = "m", .low = -1e7, .high = 1e7, .help = "south of the origin", .motion = keyed}},
      {&BodyScene::heading_rad,
       {.key = "heading_deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "where its bow points, from +x (east) toward +z (south)",
        .scale = radians_per_degree,
        .motion = keyed_angle}},
      {&BodyScene::speed_mps,
       {.key = "speed_mps",
        .unit = "m/s",
        .low = -50.0,
        .high = 50.0,
        .help = "along its heading: at its start, or along its path, added to x_m and z_m"}},
      {&BodyScene::thrust_n,
       {.key = "thrust_n",
        .unit = "N",
        .low = -1e9,
        .high = 1e9,
        .help = "of its propeller, below its stern",
        .motion = keyed,
        .slider = {{1.0, 1e7}}},
       needs_forces},
      {&BodyScene::rudder_rad,
       {.key = "rudder_deg",
        .unit = "deg",
        .low = -60.0,
        .high = 60.0,
        .help = "above 0 its heading grows: to starboard",
        .scale = radians_per_degree,
        .motion = keyed},
       needs_forces},
      {&BodyScene::propeller_m,
       {.key = "propeller_m",
        .unit = "m",
        .low = 1e-3,
        .high = 100.0,
        .help = "diameter of its propeller",
        .example = "1.2",
        .absent = "six tenths of its draught"},
       needs_forces},
      {&BodyScene::rudder_m2,
       {.key = "rudder_m2",
        .unit = "m2",
        .low = 0.0,
        .high = 1e4,
        .help = "area of its rudder",
        .example = "1",
        .absent = "a fiftieth of length times draught",
        .slider = {{0.0, 200.0}}},
       needs_forces}};
}

}  // namespace

Schema<BodyScene> body_schema() {
  Schema<BodyScene> schema("body");
  return schema.rows(ParameterGroup::body, Affects::bodies, load_rows())
      .rows(ParameterGroup::body, Affects::bodies, body_motion_rows());
}

}  // namespace offing::scene
