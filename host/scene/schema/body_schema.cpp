#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;

std::string needs_density(const UseContext&, const BodyScene& body) {
  if (body.draught_m) return "body.draught_m is given";
  return body.mass_kg ? "body.mass_kg is given" : "";
}

std::string needs_hydrodynamics(const UseContext&, const BodyScene& body) {
  return body.hydrodynamics.empty() ? "there is no body.hydrodynamics" : "";
}

std::string needs_forces(const UseContext&, const BodyScene& body) {
  return body.motion == BodyMotion::forces ? "" : "the body follows its path";
}

std::vector<Row<BodyScene>> load_rows() {
  return {{&BodyScene::name,
           {.key = "name",
            .help = "name in messages and for ocean.wake.body",
            .example = "ship",
            .absent = "none",
            .rule = ParameterRule::name}},
          {&BodyScene::mesh,
           {.key = "mesh",
            .help = "name of the mesh that floats; it must be closed, with faces outward. Its position "
                    "and turns are then relative to the body: bow +x, up +y",
            .example = "hull",
            .absent = "the first mesh",
            .rule = ParameterRule::name}},
          {&BodyScene::draught_m,
           {.key = "draught_m",
            .unit = "m",
            .low = 1e-4,
            .high = 1e4,
            .help = "depth of its lowest point in still water when it floats upright; sets its mass",
            .example = "1.8",
            .absent = "from its mass"}},
          {&BodyScene::mass_kg,
           {.key = "mass_kg",
            .unit = "kg",
            .low = 1e-3,
            .high = 1e12,
            .help = "mass, with everything it carries",
            .example = "80000",
            .absent = "from its draught or density",
            .instead_of = "draught_m"}},
          {&BodyScene::density_kgpm3,
           {.key = "density_kgpm3",
            .unit = "kg/m3",
            .low = 1.0,
            .high = 1020.0,
            .help = "mean density of the hull with everything that it encloses; sea water has 1025 kg/m3"},
           needs_density},
          {&BodyScene::mass_centre_m,
           {.key = "mass_centre_m",
            .unit = "m",
            .low = -1e4,
            .high = 1e4,
            .help = "centre of gravity: forward, up and to starboard of its hull's origin",
            .example = "[0, 0.2, 0]",
            .absent = "a quarter of its draught above its centre of buoyancy"}},
          {&BodyScene::hull_faces,
           {.key = "hull_faces",
            .low = 20.0,
            .high = 100000.0,
            .help = "largest number of hull faces used for forces; a finer mesh is replaced by a coarser one "
                    "of the same volume"}},
          {&BodyScene::hydrodynamics,
           {.key = "hydrodynamics",
            .help = "file of added mass, damping and wave excitation of its hull: NetCDF of Capytaine, or "
                    "WAMIT's .1, "
                    ".3 or .hst. Its x points forward; x = y = 0 is the hull's origin, z = 0 the still water",
            .example = "hull.nc",
            .absent = "those of a panel method",
            .rule = ParameterRule::file_name}},
          {&BodyScene::hydrodynamics_length_m,
           {.key = "hydrodynamics_length_m",
            .unit = "m",
            .low = 1e-3,
            .high = 1e4,
            .help = "length ULEN that divides the numbers of WAMIT's files"},
           needs_hydrodynamics}};
}

std::vector<Row<BodyScene>> body_motion_rows() {
  return {
      {choice(&BodyScene::motion, {"forces", "path"}),
       {.key = "motion",
        .help = "what moves it: forces (thrust, rudder and waves) or a path (x_m, z_m, heading_deg and "
                "speed_mps). It heaves, pitches and rolls either way"}},
      {&BodyScene::x_m,
       {.key = "x_m",
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "position of its centre of gravity at time 0, east of the origin; with motion = \"path\" may "
                "have keyframes",
        .motion = keyed}},
      {&BodyScene::z_m,
       {.key = "z_m",
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "position of its centre of gravity at time 0, south of the origin",
        .motion = keyed}},
      {&BodyScene::heading_rad,
       {.key = "heading_deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "direction of its bow, from +x (east) toward +z (south)",
        .scale = radians_per_degree,
        .motion = keyed_angle}},
      {&BodyScene::speed_mps,
       {.key = "speed_mps",
        .unit = "m/s",
        .low = -50.0,
        .high = 50.0,
        .help =
            "speed along its heading: at the start (forces), or all the time (path), added to x_m and z_m"}},
      {&BodyScene::thrust_n,
       {.key = "thrust_n",
        .unit = "N",
        .low = -1e9,
        .high = 1e9,
        .help = "thrust of its propeller, below its stern",
        .motion = keyed,
        .slider = {{1.0, 1e7}}},
       needs_forces},
      {&BodyScene::rudder_rad,
       {.key = "rudder_deg",
        .unit = "deg",
        .low = -60.0,
        .high = 60.0,
        .help = "rudder angle; above 0 turns it to starboard",
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
        .absent = "0.6 of its draught"},
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
       needs_forces},
      {&BodyScene::windage,
       {.key = "windage",
        .low = 0.0,
        .high = 100.0,
        .help = "factor on the force of wind on its dry faces: 0 is none, above 1 for rigging and deckhouses",
        .slider = {{0.0, 5.0}}}}};
}

constexpr std::size_t max_moorings = 32;

std::vector<Row<MooringScene>> mooring_rows() {
  return {{&MooringScene::hull_m,
           {.key = "hull_m",
            .unit = "m",
            .low = -1e4,
            .high = 1e4,
            .help = "place on the hull: forward, up and to starboard of its origin",
            .example = "[12, 1.5, 0]"}},
          {&MooringScene::anchor_m,
           {.key = "anchor_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "place of its anchor in the world: x east, y up from the still water, z south",
            .example = "[60, -20, 0]"}},
          {&MooringScene::length_m,
           {.key = "length_m",
            .unit = "m",
            .low = 0.0,
            .high = 1e5,
            .help = "length at rest; a line that is shorter than this is slack",
            .example = "55",
            .absent = "just taut where the body floats at time 0"}},
          {&MooringScene::stiffness_npm,
           {.key = "stiffness_npm",
            .unit = "N/m",
            .low = 0.0,
            .high = 1e12,
            .help = "tension per metre by which it is longer than at rest",
            .slider = {{10.0, 1e7}}}}};
}

}  // namespace

Schema<BodyScene> body_schema() {
  Schema<MooringScene> moorings("mooring");
  moorings.rows(ParameterGroup::mooring, Affects::bodies, mooring_rows());
  Schema<BodyScene> schema("body");
  return schema.rows(ParameterGroup::body, Affects::bodies, load_rows())
      .rows(ParameterGroup::body, Affects::bodies, body_motion_rows())
      .list(&BodyScene::moorings, max_moorings, moorings);
}

}  // namespace offing::scene
