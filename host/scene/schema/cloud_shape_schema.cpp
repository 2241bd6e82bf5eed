#include <utility>

#include "host/clouds/light/phase_function.h"
#include "host/mesh_shapes/shape_table.h"
#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

constexpr auto singles = &Scene::clouds;
constexpr auto form = &CloudScene::shape;
constexpr auto noise = &CloudScene::noise;
constexpr auto look = &CloudScene::look;
constexpr auto motion = &CloudScene::motion;
constexpr auto heat = &CloudMotionScene::heat;
constexpr std::size_t max_clouds = 4096;
constexpr std::string_view as_genus = "as its genus";

std::vector<Parameter> in_clouds(std::vector<Parameter> rows) {
  for (Parameter& row : rows) {
    const bool may_be_absent = std::holds_alternative<ValueAt<std::optional<double>>>(row.storage) ||
                               std::holds_alternative<ValueAt<std::optional<glm::dvec3>>>(row.storage);
    if (may_be_absent && row.absent.empty()) row.absent = as_genus;
  }
  return rows_of_section(section_of_list<singles>, ParameterGroup::cloud, max_clouds, std::move(rows));
}

std::vector<Parameter> form_rows() {
  using enum ParameterUse;
  std::vector<std::string_view> solids = mesh_shapes::names_of(mesh_shapes::closed_shapes());
  solids.insert(solids.begin(), "none");
  return in_clouds(
      {{.key = "cloud.file",
        .storage = &element<singles, form, &CloudShapeScene::file>,
        .help = "OpenVDB (.vdb) whose density is sampled, or particles (.ply), in place of balls",
        .example = "cumulus.vdb",
        .absent = "none",
        .rule = ParameterRule::file_name},
       {.key = "cloud.grid",
        .storage = &element<singles, form, &CloudShapeScene::grid>,
        .help = "which grid of a .vdb is the density",
        .example = "smoke",
        .absent = "density",
        .rule = ParameterRule::name,
        .use = filed_cloud},
       {.key = "cloud.up",
        .storage = choice_at<&element<singles, form, &CloudShapeScene::up>>({"y", "z"}),
        .help = "which axis of the file points up: z in files that Blender writes",
        .use = filed_cloud},
       {.key = "cloud.mesh",
        .storage = &element<singles, form, &CloudShapeScene::mesh>,
        .help = "a closed mesh that is filled, in place of balls",
        .example = "bird.ply",
        .absent = "none",
        .rule = ParameterRule::file_name},
       {.key = "cloud.text",
        .storage = &element<singles, form, &CloudShapeScene::text>,
        .help = "letters that are filled, in place of balls",
        .example = "K",
        .absent = "none",
        .rule = ParameterRule::name},
       {.key = "cloud.shape",
        .storage = choice_at<&element<singles, form, &CloudShapeScene::solid>>(solids),
        .help = "a shape of offing-mesh generate that is filled, in place of balls"},
       {.key = "cloud.yaw_deg",
        .storage = &element<singles, form, &CloudShapeScene::yaw_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turned clockwise, seen from above; a .vdb by quarter turns only",
        .scale = radians_per_degree,
        .use = turned_cloud},
       {.key = "cloud.pitch_deg",
        .storage = &element<singles, form, &CloudShapeScene::pitch_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turned about its own x axis, its -z side up",
        .scale = radians_per_degree,
        .use = turned_cloud},
       {.key = "cloud.roll_deg",
        .storage = &element<singles, form, &CloudShapeScene::roll_rad>,
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "turned about its own z axis first of all, its +x side down",
        .scale = radians_per_degree,
        .use = turned_cloud},
       {.key = "cloud.size_m",
        .storage = &element<singles, form, &CloudShapeScene::size_m>,
        .unit = "m",
        .low = 0.1,
        .high = 1e5,
        .help = "height of a text; longest edge of the box around a mesh or shape, before it is turned",
        .use = shaped_cloud},
       {.key = "cloud.depth_m",
        .storage = &element<singles, form, &CloudShapeScene::depth_m>,
        .unit = "m",
        .low = 0.1,
        .high = 1e5,
        .help = "of letters, from front to back",
        .use = text_cloud},
       {.key = "cloud.thickness_m",
        .storage = &element<singles, form, &CloudShapeScene::thickness_m>,
        .unit = "m",
        .low = 1e-3,
        .high = 1e5,
        .help = "how deep below the surface of a mesh or a text its density has risen to 1",
        .use = shaped_cloud},
       {.key = "cloud.fluff_m",
        .storage = &element<singles, form, &CloudShapeScene::fluff_m>,
        .unit = "m",
        .low = 0.0,
        .high = 1e5,
        .help = "how far beyond that surface it begins",
        .use = shaped_cloud}});
}

std::vector<Parameter> noise_rows() {
  return in_clouds(
      {{.key = "cloud.noise_wavelength_m",
        .storage = &element<singles, noise, &CloudNoiseScene::wavelength_m>,
        .unit = "m",
        .low = 1e-2,
        .high = 1e6,
        .help = "of the longest octave of the noise that frays it",
        .example = "200"},
       {.key = "cloud.noise_octaves",
        .storage = &element<singles, noise, &CloudNoiseScene::octaves>,
        .low = 0.0,
        .high = 12.0,
        .help = "how many, 0: as its genus"},
       {.key = "cloud.noise_lacunarity",
        .storage = &element<singles, noise, &CloudNoiseScene::lacunarity>,
        .low = 1.1,
        .high = 8.0,
        .help = "ratio of the wave numbers of two octaves",
        .example = "2"},
       {.key = "cloud.noise_gain",
        .storage = &element<singles, noise, &CloudNoiseScene::gain>,
        .low = 0.0,
        .high = 1.0,
        .help = "ratio of their amplitudes",
        .example = "0.5"},
       {.key = "cloud.noise_strength",
        .storage = &element<singles, noise, &CloudNoiseScene::strength>,
        .low = 0.0,
        .high = 100.0,
        .help = "factor of the noise",
        .example = "1"},
       {.key = "cloud.noise_blend",
        .storage = &element<singles, noise, &CloudNoiseScene::blend>,
        .low = 0.0,
        .high = 1.0,
        .help = "share of the noise in the density",
        .example = "0.5"},
       {.key = "cloud.noise_wisp",
        .storage = &element<singles, noise, &CloudNoiseScene::wisp>,
        .low = 0.1,
        .high = 10.0,
        .help = "exponent of the density: above 1 it is thinner where it is thin",
        .example = "1.5"},
       {.key = "cloud.noise_edge",
        .storage = &element<singles, noise, &CloudNoiseScene::edge>,
        .low = 1e-6,
        .high = 100.0,
        .help = "density of the balls below which the noise fades out",
        .example = "0.3"},
       {.key = "cloud.noise_change_per_s",
        .storage = &element<singles, noise, &CloudNoiseScene::change_per_s>,
        .unit = "1/s",
        .low = 0.0,
        .high = 100.0,
        .help = "how fast the eddies of sway_m change: 1 / s is other ones each second; what frays it stays",
        .example = "0.01"}});
}

std::vector<Parameter> look_rows() {
  return in_clouds(
      {{.key = "cloud.extinction_per_m",
        .storage = &element<singles, look, &CloudLookScene::extinction_per_m>,
        .unit = "1/m",
        .low = 1e-9,
        .high = 100.0,
        .help = "of density 1: light falls to 37 % over its inverse",
        .example = "0.02"},
       {.key = "cloud.colour",
        .storage = &element<singles, look, &CloudLookScene::albedo>,
        .low = 0.0,
        .high = 1.0,
        .help = "share of light that is scattered and not swallowed, red, green, blue; water has 1",
        .example = "[1, 0.9, 0.8]"},
       {.key = "cloud.phase",
        .storage = choice_at<&element<singles, look, &CloudLookScene::phase>>(
            {"as_genus", "rayleigh", "henyey_greenstein", "double_henyey_greenstein", "mie_droplet"}),
        .help = "how light is scattered over directions"},
       {.key = "cloud.puffs",
        .storage =
            choice_at<&element<singles, look, &CloudLookScene::billboards>>({"as_genus", "crisp", "soft"}),
        .help = "textures of its particles: crisp as a cauliflower, or soft wisps"},
       {.key = "cloud.g",
        .storage = &element<singles, look, &CloudLookScene::g>,
        .low = clouds::least_mean_cosine,
        .high = 0.99,
        .help = "mean cosine of scattering, of a double one its forward lobe's",
        .example = "0.85"},
       {.key = "cloud.g_back",
        .storage = &element<singles, look, &CloudLookScene::g_back>,
        .low = -0.99,
        .high = 0.99,
        .help = "of a double one its backward lobe's",
        .example = "-0.3"},
       {.key = "cloud.forward_share",
        .storage = &element<singles, look, &CloudLookScene::forward_share>,
        .low = 0.0,
        .high = 1.0,
        .help = "of the forward lobe of a double one",
        .example = "0.95"},
       {.key = "cloud.droplet_um",
        .storage = &element<singles, look, &CloudLookScene::droplet_um>,
        .unit = "um",
        .low = clouds::smallest_droplet_um,
        .high = clouds::largest_droplet_um,
        .help = "diameter of the droplets of phase = \"mie_droplet\"",
        .example = "10"}});
}

std::vector<Parameter> motion_rows() {
  return in_clouds({{.key = "cloud.wind_mps",
                     .storage = &element<singles, motion, &CloudMotionScene::wind_mps>,
                     .unit = "m/s",
                     .low = -300.0,
                     .high = 300.0,
                     .help = "wind that carries it, x, y, z",
                     .example = "[8, 0, 2]",
                     .absent = "none: it stands still"},
                    {.key = "cloud.shear_per_s",
                     .storage = &element<singles, motion, &CloudMotionScene::shear_per_s>,
                     .unit = "1/s",
                     .low = -1.0,
                     .high = 1.0,
                     .help = "how much faster that wind is, a metre higher",
                     .example = "0.005"},
                    {.key = "cloud.drag_s",
                     .storage = &element<singles, motion, &CloudMotionScene::drag_s>,
                     .unit = "s",
                     .low = 0.0,
                     .high = 1e4,
                     .help = "how far thin parts run ahead of dense ones with the wind",
                     .example = "5"},
                    {.key = "cloud.sway_m",
                     .storage = &element<singles, motion, &CloudMotionScene::sway_m>,
                     .unit = "m",
                     .low = 0.0,
                     .high = 1e5,
                     .help = "how far eddies of the noise move its parts",
                     .example = "30"},
                    {.key = "cloud.obstacle_m",
                     .storage = &element<singles, motion, &CloudMotionScene::obstacle_m>,
                     .unit = "m",
                     .low = -1e7,
                     .high = 1e7,
                     .help = "middle of a ball that it flows around, x, y, z of the world",
                     .example = "[0, 1000, 0]",
                     .absent = "none"},
                    {.key = "cloud.obstacle_radius_m",
                     .storage = &element<singles, motion, &CloudMotionScene::obstacle_radius_m>,
                     .unit = "m",
                     .low = 1e-3,
                     .high = 1e6,
                     .help = "of that ball",
                     .use = ParameterUse::obstructed_cloud}});
}

std::vector<Parameter> heat_rows() {
  using clouds::CloudHeat;
  std::vector<Parameter> rows{
      {.key = "cloud.heat_k",
       .storage = &element<singles, motion, &CloudMotionScene::heat_k>,
       .unit = "K",
       .low = 0.0,
       .high = 50.0,
       .help = "how much warmer than the air around it begins: it rises, forms, cools and dissolves",
       .example = "2",
       .absent = "it neither rises nor sinks"},
      {.key = "cloud.heat_begins_s",
       .storage = &element<singles, motion, heat, &CloudHeat::begins_s>,
       .unit = "s",
       .low = -1e8,
       .high = 1e8,
       .help = "when"},
      {.key = "cloud.heat_spread",
       .storage = &element<singles, motion, heat, &CloudHeat::spread>,
       .low = 0.0,
       .high = 1.0,
       .help = "how much that differs between its parts"},
      {.key = "cloud.heat_cooling_s",
       .storage = &element<singles, motion, heat, &CloudHeat::cooling_s>,
       .unit = "s",
       .low = 1.0,
       .high = 1e8,
       .help = "time in which it falls to 37 %"},
      {.key = "cloud.heat_stability_per_s",
       .storage = &element<singles, motion, heat, &CloudHeat::stability_per_s>,
       .unit = "1/s",
       .low = 1e-4,
       .high = 1.0,
       .help = "of the air: angular frequency at which it swings"},
      {.key = "cloud.heat_damping_per_s",
       .storage = &element<singles, motion, heat, &CloudHeat::damping_per_s>,
       .unit = "1/s",
       .low = 0.0,
       .high = 0.99,
       .help = "of the swings, below heat_stability_per_s"},
      {.key = "cloud.heat_condensation_m",
       .storage = &element<singles, motion, heat, &CloudHeat::condensation_m>,
       .unit = "m",
       .low = -1e6,
       .high = 1e6,
       .help = "height above its middle from which there is cloud"},
      {.key = "cloud.heat_condensing_m",
       .storage = &element<singles, motion, heat, &CloudHeat::condensing_m>,
       .unit = "m",
       .low = 1e-3,
       .high = 1e6,
       .help = "how far above that all of it is there"}};
  for (Parameter& row : rows) {
    if (row.key != "cloud.heat_k") row.use = ParameterUse::heated_cloud;
  }
  return in_clouds(std::move(rows));
}

}  // namespace

std::vector<Parameter> cloud_shape_parameters() {
  std::vector<Parameter> rows;
  for (const std::vector<Parameter>& more :
       {form_rows(), noise_rows(), look_rows(), motion_rows(), heat_rows()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace offing::scene
