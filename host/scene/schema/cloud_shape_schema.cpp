#include "host/clouds/light/phase_function.h"
#include "host/mesh_shapes/shape_table.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

constexpr auto form = &CloudScene::shape;
constexpr auto noise = &CloudScene::noise;
constexpr auto look = &CloudScene::look;
constexpr auto motion = &CloudScene::motion;
constexpr auto heat = &CloudMotionScene::heat;

std::string needs_file(const UseContext&, const CloudScene& cloud) {
  return cloud.shape.file.empty() ? "cloud.file is not given" : "";
}

std::string needs_solid(const UseContext&, const CloudScene& cloud) {
  const CloudShapeScene& shape = cloud.shape;
  return shape.mesh.empty() && shape.text.empty() && !shape.solid
             ? "none of cloud.mesh, cloud.text and cloud.shape is given"
             : "";
}

std::string needs_form(const UseContext&, const CloudScene& cloud) {
  return cloud.shape.is_given() ? "" : "none of cloud.file, cloud.mesh, cloud.text and cloud.shape is given";
}

std::string needs_text(const UseContext&, const CloudScene& cloud) {
  return cloud.shape.text.empty() ? "cloud.text is not given" : "";
}

std::string needs_heat(const UseContext&, const CloudScene& cloud) {
  return cloud.motion.heat_k ? "" : "cloud.heat_k is not given";
}

std::string needs_obstacle(const UseContext&, const CloudScene& cloud) {
  return cloud.motion.obstacle_m ? "" : "cloud.obstacle_m is not given";
}

std::vector<Row<CloudScene>> cloud_form_rows() {
  return {
      {path(form, &CloudShapeScene::file),
       {.key = "file",
        .help = "OpenVDB file (.vdb) whose density is sampled, or particles (.ply), instead of balls",
        .example = "cumulus.vdb",
        .absent = "none",
        .rule = ParameterRule::file_name}},
      {path(form, &CloudShapeScene::grid),
       {.key = "grid",
        .help = "name of the .vdb grid that holds the density",
        .example = "smoke",
        .absent = "density",
        .rule = ParameterRule::name},
       needs_file},
      {choice(path(form, &CloudShapeScene::up), {"y", "z"}),
       {.key = "up", .help = "axis of the file that points up: z in files that Blender writes"},
       needs_file},
      {path(form, &CloudShapeScene::mesh),
       {.key = "mesh",
        .help = "closed mesh to fill with cloud, instead of balls",
        .example = "bird.ply",
        .absent = "none",
        .rule = ParameterRule::file_name}},
      {path(form, &CloudShapeScene::text),
       {.key = "text",
        .help = "letters to fill with cloud, instead of balls",
        .example = "K",
        .absent = "none",
        .rule = ParameterRule::name}},
      {choice_or("none", path(form, &CloudShapeScene::solid),
                 mesh_shapes::names_of(mesh_shapes::closed_shapes())),
       {.key = "shape", .help = "shape of `offing-mesh generate` to fill with cloud, instead of balls"}},
      {path(form, &CloudShapeScene::yaw_rad),
       {.key = "yaw_deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turn clockwise, seen from above; a .vdb only by quarter turns",
        .scale = radians_per_degree},
       needs_form},
      {path(form, &CloudShapeScene::pitch_rad),
       {.key = "pitch_deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turn about its own x axis, which raises its -z side",
        .scale = radians_per_degree},
       needs_form},
      {path(form, &CloudShapeScene::roll_rad),
       {.key = "roll_deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turn about its own z axis, which lowers its +x side; applied first",
        .scale = radians_per_degree},
       needs_form},
      {path(form, &CloudShapeScene::size_m),
       {.key = "size_m",
        .unit = "m",
        .low = 0.1,
        .high = 1e5,
        .help = "height of a text, or longest edge of the box around a mesh or shape before it is turned"},
       needs_solid},
      {path(form, &CloudShapeScene::depth_m),
       {.key = "depth_m",
        .unit = "m",
        .low = 0.1,
        .high = 1e5,
        .help = "depth of letters, from front to back"},
       needs_text},
      {path(form, &CloudShapeScene::thickness_m),
       {.key = "thickness_m",
        .unit = "m",
        .low = 1e-3,
        .high = 1e5,
        .help = "depth below the surface of a mesh or text at which density reaches 1"},
       needs_solid},
      {path(form, &CloudShapeScene::fluff_m),
       {.key = "fluff_m",
        .unit = "m",
        .low = 0.0,
        .high = 1e5,
        .help = "distance outside that surface at which density begins"},
       needs_solid}};
}

std::vector<Row<CloudScene>> noise_rows() {
  return {
      {path(noise, &CloudNoiseScene::wavelength_m),
       {.key = "noise_wavelength_m",
        .unit = "m",
        .low = 1e-2,
        .high = 1e6,
        .help = "wavelength of the longest octave of the noise that frays the cloud",
        .example = "200"}},
      {path(noise, &CloudNoiseScene::octaves),
       {.key = "noise_octaves",
        .low = 0.0,
        .high = 12.0,
        .help = "number of octaves of the noise; 0: set by the genus"}},
      {path(noise, &CloudNoiseScene::lacunarity),
       {.key = "noise_lacunarity",
        .low = 1.1,
        .high = 8.0,
        .help = "ratio of the wave numbers of successive octaves",
        .example = "2"}},
      {path(noise, &CloudNoiseScene::gain),
       {.key = "noise_gain",
        .low = 0.0,
        .high = 1.0,
        .help = "ratio of the amplitudes of successive octaves",
        .example = "0.5"}},
      {path(noise, &CloudNoiseScene::strength),
       {.key = "noise_strength", .low = 0.0, .high = 100.0, .help = "factor on the noise", .example = "1"}},
      {path(noise, &CloudNoiseScene::blend),
       {.key = "noise_blend",
        .low = 0.0,
        .high = 1.0,
        .help = "share of the noise in the density",
        .example = "0.5"}},
      {path(noise, &CloudNoiseScene::wisp),
       {.key = "noise_wisp",
        .low = 0.1,
        .high = 10.0,
        .help = "exponent on the density: above 1 makes thin parts thinner",
        .example = "1.5"}},
      {path(noise, &CloudNoiseScene::edge),
       {.key = "noise_edge",
        .low = 1e-6,
        .high = 100.0,
        .help = "density of the balls below which the noise fades out",
        .example = "0.3"}},
      {path(noise, &CloudNoiseScene::change_per_s),
       {.key = "noise_change_per_s",
        .unit = "1/s",
        .low = 0.0,
        .high = 100.0,
        .help = "how fast the eddies of sway_m change: 1 gives new eddies each second. The fraying noise "
                "stays the same",
        .example = "0.01"}}};
}

std::vector<Row<CloudScene>> look_rows() {
  return {{path(look, &CloudLookScene::extinction_per_m),
           {.key = "extinction_per_m",
            .unit = "1/m",
            .low = 1e-9,
            .high = 100.0,
            .help = "extinction at density 1: light falls to 37 % over a distance of 1 / extinction_per_m",
            .example = "0.02"}},
          {path(look, &CloudLookScene::albedo),
           {.key = "colour",
            .low = 0.0,
            .high = 1.0,
            .help = "share of red, green and blue light that is scattered instead of absorbed; water has 1",
            .example = "[1, 0.9, 0.8]"}},
          {choice_or("as_genus", path(look, &CloudLookScene::phase),
                     {"rayleigh", "henyey_greenstein", "double_henyey_greenstein", "mie_droplet"}),
           {.key = "phase", .help = "phase function: how light is scattered over directions"}},
          {choice_or("as_genus", path(look, &CloudLookScene::billboards), {"crisp", "soft"}),
           {.key = "billboards",
            .alias = "puffs",
            .help = "textures of its particles: crisp like a cauliflower, or soft wisps"}},
          {path(look, &CloudLookScene::g),
           {.key = "g",
            .low = clouds::least_mean_cosine,
            .high = 0.99,
            .help = "mean cosine of scattering; for double_henyey_greenstein, of the forward lobe",
            .example = "0.85"}},
          {path(look, &CloudLookScene::g_back),
           {.key = "g_back",
            .low = -0.99,
            .high = 0.99,
            .help = "mean cosine of the backward lobe of double_henyey_greenstein",
            .example = "-0.3"}},
          {path(look, &CloudLookScene::forward_share),
           {.key = "forward_share",
            .low = 0.0,
            .high = 1.0,
            .help = "share of the forward lobe of double_henyey_greenstein",
            .example = "0.95"}},
          {path(look, &CloudLookScene::droplet_um),
           {.key = "droplet_um",
            .unit = "um",
            .low = clouds::smallest_droplet_um,
            .high = clouds::largest_droplet_um,
            .help = "diameter of the droplets of phase = \"mie_droplet\"",
            .example = "10"}}};
}

std::vector<Row<CloudScene>> cloud_motion_rows() {
  return {{path(motion, &CloudMotionScene::wind_mps),
           {.key = "wind_mps",
            .unit = "m/s",
            .low = -300.0,
            .high = 300.0,
            .help = "wind that carries it: x, y, z",
            .example = "[8, 0, 2]",
            .absent = "none: it stands still"}},
          {path(motion, &CloudMotionScene::shear_per_s),
           {.key = "shear_per_s",
            .unit = "1/s",
            .low = -1.0,
            .high = 1.0,
            .help = "increase of that wind per metre of height",
            .example = "0.005"}},
          {path(motion, &CloudMotionScene::drag_s),
           {.key = "drag_s",
            .unit = "s",
            .low = 0.0,
            .high = 1e4,
            .help = "time by which thin parts run ahead of dense ones with the wind",
            .example = "5"}},
          {path(motion, &CloudMotionScene::sway_m),
           {.key = "sway_m",
            .unit = "m",
            .low = 0.0,
            .high = 1e5,
            .help = "how far the eddies of the noise move its parts",
            .example = "30"}},
          {path(motion, &CloudMotionScene::obstacle_m),
           {.key = "obstacle_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "centre of a ball that it flows around: x, y, z of the world",
            .example = "[0, 1000, 0]",
            .absent = "none"}},
          {path(motion, &CloudMotionScene::obstacle_radius_m),
           {.key = "obstacle_radius_m", .unit = "m", .low = 1e-3, .high = 1e6, .help = "radius of that ball"},
           needs_obstacle}};
}

std::vector<Row<CloudScene>> heat_rows() {
  using clouds::CloudHeat;
  std::vector<Row<CloudScene>> rows{
      {path(motion, &CloudMotionScene::heat_k),
       {.key = "heat_k",
        .unit = "K",
        .low = 0.0,
        .high = 50.0,
        .help = "how much warmer it starts than the air around it; a warm cloud rises, forms, cools and "
                "dissolves",
        .example = "2",
        .absent = "none: it neither rises nor sinks"}},
      {path(motion, heat, &CloudHeat::begins_s),
       {.key = "heat_begins_s",
        .unit = "s",
        .low = -1e8,
        .high = 1e8,
        .help = "time at which it starts to rise"}},
      {path(motion, heat, &CloudHeat::spread),
       {.key = "heat_spread", .low = 0.0, .high = 1.0, .help = "how much heat_k differs between its parts"}},
      {path(motion, heat, &CloudHeat::cooling_s),
       {.key = "heat_cooling_s",
        .unit = "s",
        .low = 1.0,
        .high = 1e8,
        .help = "time in which its extra heat falls to 37 %"}},
      {path(motion, heat, &CloudHeat::stability_per_s),
       {.key = "heat_stability_per_s",
        .unit = "1/s",
        .low = 1e-4,
        .high = 1.0,
        .help = "stability of the air, as the angular frequency of its oscillation"}},
      {path(motion, heat, &CloudHeat::damping_per_s),
       {.key = "heat_damping_per_s",
        .unit = "1/s",
        .low = 0.0,
        .high = 0.99,
        .help = "damping of that oscillation; must be below heat_stability_per_s"}},
      {path(motion, heat, &CloudHeat::condensation_m),
       {.key = "heat_condensation_m",
        .unit = "m",
        .low = -1e6,
        .high = 1e6,
        .help = "height above its middle at which it starts to form"}},
      {path(motion, heat, &CloudHeat::condensing_m),
       {.key = "heat_condensing_m",
        .unit = "m",
        .low = 1e-3,
        .high = 1e6,
        .help = "height above that at which it has formed completely"}}};
  for (Row<CloudScene>& row : rows) {
    if (row.facts.key != "heat_k") row.unused = needs_heat;
  }
  return rows;
}

}  // namespace

std::vector<Row<CloudScene>> cloud_shape_rows() {
  std::vector<Row<CloudScene>> all;
  for (const auto& rows : {cloud_form_rows(), noise_rows(), look_rows(), cloud_motion_rows(), heat_rows()}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  for (Row<CloudScene>& row : all) {
    const bool may_be_absent = std::holds_alternative<ValueAt<std::optional<double>>>(row.where.storage) ||
                               std::holds_alternative<ValueAt<std::optional<glm::dvec3>>>(row.where.storage);
    if (may_be_absent && row.facts.absent.empty()) row.facts.absent = "set by the genus";
  }
  return all;
}

}  // namespace offing::scene
