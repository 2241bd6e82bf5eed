#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;
constexpr auto bodies = &Scene::bodies;
// What the shaders of the water keep dry (present/passes/water/hull_mask.glsl).
constexpr std::size_t max_bodies = 16;

std::vector<Parameter> in_bodies(std::vector<Parameter> rows) {
  return rows_of_section(section_of_list<bodies>, ParameterGroup::body, max_bodies, std::move(rows));
}

std::vector<Parameter> load_rows() {
  return in_bodies(
      {{.key = "body.name",
        .storage = &element<bodies, &BodyScene::name>,
        .help = "for messages and for ocean.wake.body",
        .example = "ship",
        .absent = "none",
        .rule = ParameterRule::name},
       {.key = "body.mesh",
        .storage = &element<bodies, &BodyScene::mesh>,
        .help = "name of the [[mesh]] that floats: closed, its faces turned outward; place and turn of that "
                "mesh are within the body then, whose bow is +x, whose top +y",
        .example = "hull",
        .absent = "the first mesh",
        .rule = ParameterRule::name},
       {.key = "body.draught_m",
        .storage = &element<bodies, &BodyScene::draught_m>,
        .unit = "m",
        .low = 1e-4,
        .high = 1e4,
        .help = "how deep its lowest place is below still water while it floats upright; gives its mass",
        .example = "1.8",
        .absent = "that of its mass"},
       {.key = "body.mass_kg",
        .storage = &element<bodies, &BodyScene::mass_kg>,
        .unit = "kg",
        .low = 1e-3,
        .high = 1e12,
        .help = "with all that it carries",
        .example = "80000",
        .absent = "that of its draught or density",
        .instead_of = "body.draught_m"},
       {.key = "body.density_kgpm3",
        .storage = &element<bodies, &BodyScene::density_kgpm3>,
        .unit = "kg/m3",
        .low = 1.0,
        .high = 1020.0,
        .help = "of all that its hull encloses, in sea water of 1025 kg/m3",
        .use = ParameterUse::body_of_density},
       {.key = "body.mass_centre_m",
        .storage = &element<bodies, &BodyScene::mass_centre_m>,
        .unit = "m",
        .low = -1e4,
        .high = 1e4,
        .help = "its centre of gravity, forward, up and to starboard of the origin of its hull",
        .example = "[0, 0.2, 0]",
        .absent = "above its centre of buoyancy by a quarter of its draught"},
       {.key = "body.hull_faces",
        .storage = &element<bodies, &BodyScene::hull_faces>,
        .low = 20.0,
        .high = 100000.0,
        .help =
            "most faces that water presses on: a finer mesh floats as a coarser one of the same volume"}});
}

std::vector<Parameter> motion_rows() {
  return in_bodies(
      {{.key = "body.motion",
        .storage = choice_at<&element<bodies, &BodyScene::motion>>({"forces", "path"}),
        .help = "what moves it over the water: thrust, rudder and waves from its start on, or x_m, z_m, "
                "heading_deg and speed_mps at any time; it heaves, pitches and rolls either way"},
       {.key = "body.x_m",
        .storage = &element<bodies, &BodyScene::x_m>,
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "its centre of gravity at time 0, east of the origin; keyframes for a path",
        .motion = keyed},
       {.key = "body.z_m",
        .storage = &element<bodies, &BodyScene::z_m>,
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "south of the origin",
        .motion = keyed},
       {.key = "body.heading_deg",
        .storage = &element<bodies, &BodyScene::heading_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "where its bow points, from +x (east) toward +z (south)",
        .scale = radians_per_degree,
        .motion = keyed_angle},
       {.key = "body.speed_mps",
        .storage = &element<bodies, &BodyScene::speed_mps>,
        .unit = "m/s",
        .low = -50.0,
        .high = 50.0,
        .help = "along its heading: at its start, or along its path, added to x_m and z_m"},
       {.key = "body.thrust_n",
        .storage = &element<bodies, &BodyScene::thrust_n>,
        .unit = "N",
        .low = -1e9,
        .high = 1e9,
        .help = "of its propeller, below its stern",
        .use = ParameterUse::driven_body,
        .motion = keyed,
        .slider = {{1.0, 1e7}}},
       {.key = "body.rudder_deg",
        .storage = &element<bodies, &BodyScene::rudder_rad>,
        .unit = "deg",
        .low = -60.0,
        .high = 60.0,
        .help = "above 0 its heading grows: to starboard",
        .scale = radians_per_degree,
        .use = ParameterUse::driven_body,
        .motion = keyed},
       {.key = "body.propeller_m",
        .storage = &element<bodies, &BodyScene::propeller_m>,
        .unit = "m",
        .low = 1e-3,
        .high = 100.0,
        .help = "diameter of its propeller",
        .example = "1.2",
        .absent = "six tenths of its draught",
        .use = ParameterUse::driven_body},
       {.key = "body.rudder_m2",
        .storage = &element<bodies, &BodyScene::rudder_m2>,
        .unit = "m2",
        .low = 0.0,
        .high = 1e4,
        .help = "area of its rudder",
        .example = "1",
        .absent = "a fiftieth of length times draught",
        .use = ParameterUse::driven_body,
        .slider = {{0.0, 200.0}}}});
}

}  // namespace

std::vector<Parameter> body_parameters() {
  std::vector<Parameter> rows = load_rows();
  const std::vector<Parameter> of_motion = motion_rows();
  rows.insert(rows.end(), of_motion.begin(), of_motion.end());
  return rows;
}

}  // namespace offing::scene
