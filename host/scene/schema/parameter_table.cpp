#include "host/scene/schema/parameter_table.h"

#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

using ocean::FoamParameters;
using ocean::OceanParameters;

std::vector<Parameter> world_rows() {
  using enum ParameterGroup;
  constexpr auto parameters = &Scene::ocean;
  return {
      {.key = "world.seed",
       .flag = "--seed",
       .group = world,
       .storage = &member<parameters, &OceanParameters::seed>,
       .high = 9223372036854775807.0,
       .help = "number that picks one sea among all of the same spectrum"},

      {.key = "world.latitude_deg",
       .flag = "",
       .group = world,
       .storage = &member<&Scene::latitude_rad>,
       .unit = "deg",
       .low = -90.0,
       .high = 90.0,
       .help = "of the origin, north positive: for the place of the sun",
       .scale = radians_per_degree,
       .use = ParameterUse::dated_sun},
      {.key = "world.longitude_deg",
       .flag = "",
       .group = world,
       .storage = &member<&Scene::longitude_rad>,
       .unit = "deg",
       .low = -180.0,
       .high = 360.0,
       .help = "of the origin, east positive: for the place of the sun",
       .scale = radians_per_degree,
       .use = ParameterUse::dated_sun},

      {.key = "time.fps",
       .flag = "--fps",
       .group = time,
       .storage = &member<&Scene::frames_per_second>,
       .unit = "1/s",
       .low = 0.001,
       .high = 1e6,
       .help = "frames per second: frame i shows time i / fps"},
      {.key = "time.start_s",
       .flag = "",
       .group = time,
       .storage = &member<&Scene::start_s>,
       .unit = "s",
       .low = 0.0,
       .high = 1e6,
       .help = "time of the first frame"},
      {.key = "time.end_s",
       .flag = "",
       .group = time,
       .storage = &member<&Scene::end_s>,
       .unit = "s",
       .low = 0.0,
       .high = 1e6,
       .help = "frames stop before this time"},
      {.key = "time.loop_period_s",
       .flag = "--loop-period-s",
       .group = time,
       .storage = &member<parameters, &OceanParameters::loop_period_s>,
       .unit = "s",
       .low = 0.1,
       .high = 1e5,
       .help = "the sea repeats exactly after this time; natural from about 10 s on",
       .example = "20",
       .absent = "no loop"},

      {.key = "wind.speed_mps",
       .flag = "",
       .group = wind,
       .storage = &member<&Scene::wind_speed_mps>,
       .unit = "m/s",
       .low = 0.1,
       .high = 60.0,
       .help = "wind speed for everything that wind moves",
       .use = ParameterUse::wind},
      {.key = "wind.direction_deg",
       .flag = "",
       .group = wind,
       .storage = &member<&Scene::wind_direction_rad>,
       .unit = "deg",
       .low = -360.0,
       .high = 360.0,
       .help = "direction of travel, from +x (east) toward +z (south)",
       .scale = radians_per_degree,
       .use = ParameterUse::wind_direction},
  };
}

std::vector<Parameter> grid_rows() {
  using enum ParameterGroup;
  constexpr auto parameters = &Scene::ocean;
  constexpr auto foam_parameters = &OceanParameters::foam;
  return {
      {.key = "ocean.size",
       .flag = "--size",
       .group = grid,
       .storage = &member<parameters, &OceanParameters::size>,
       .low = 16.0,
       .high = 4096.0,
       .help = "samples along a patch",
       .rule = ParameterRule::power_of_two},
      {.key = "ocean.cascade_count",
       .flag = "--cascades",
       .group = grid,
       .storage = &member<&Scene::cascade_count>,
       .low = 1.0,
       .high = 4.0,
       .help = "most cascades to choose where no patch is given",
       .use = ParameterUse::chosen_cascades},
      {.key = "ocean.cascade.patch_m",
       .flag = "--patch-m",
       .group = grid,
       .storage = &member<&Scene::patch_lengths_m>,
       .unit = "m",
       .low = 0.1,
       .high = 1e6,
       .help = "length of a cascade's patch; repeat it or separate by commas",
       .example = "250",
       .absent = "chosen from the spectrum",
       .max_count = 4},
      {.key = "ocean.gerstner.count",
       .flag = "--gerstner-count",
       .group = grid,
       .storage = &member<&Scene::gerstner_count>,
       .high = 64.0,
       .help = "Gerstner waves for the long end of the spectrum; with 0 the cascades carry all of it"},
      {.key = "ocean.gerstner.split_wavelength_m",
       .flag = "--gerstner-split-m",
       .group = grid,
       .storage = &member<&Scene::gerstner_split_m>,
       .unit = "m",
       .low = 0.1,
       .high = 1e5,
       .help = "waves longer than this are Gerstner waves, the others are left to the cascades",
       .example = "50",
       .absent = "a third of the peak's wavelength",
       .use = ParameterUse::gerstner},
      {.key = "ocean.choppiness",
       .flag = "--choppiness",
       .group = grid,
       .storage = &member<parameters, &OceanParameters::choppiness>,
       .low = 0.0,
       .high = 5.0,
       .help = "horizontal displacement: 0 none, 1 as linear theory has it"},

      {.key = "ocean.foam.onset_jacobian",
       .flag = "--foam-onset",
       .group = foam,
       .storage = &member<parameters, foam_parameters, &FoamParameters::onset_jacobian>,
       .low = -10.0,
       .high = 1.0,
       .help = "Jacobian at which foam begins; offing-view draws less of it in winds below 6 m/s and none "
               "below 3.7"},
      {.key = "ocean.foam.width",
       .flag = "--foam-width",
       .group = foam,
       .storage = &member<parameters, foam_parameters, &FoamParameters::width>,
       .low = 0.001,
       .high = 10.0,
       .help = "how far below the onset foam covers all"},
      {.key = "ocean.foam.decay_s",
       .flag = "--foam-decay-s",
       .group = foam,
       .storage = &member<parameters, foam_parameters, &FoamParameters::decay_s>,
       .unit = "s",
       .low = 0.01,
       .high = 100.0,
       .help = "time in which foam fades to 1/e"},
      {.key = "ocean.foam.step_s",
       .flag = "--foam-step-s",
       .group = foam,
       .storage = &member<parameters, foam_parameters, &FoamParameters::step_s>,
       .unit = "s",
       .low = 0.01,
       .high = 10.0,
       .help = "spacing of the past instants that foam remembers"},
  };
}

}  // namespace

std::span<const Parameter> parameter_table() {
  static const std::vector<Parameter> table = [] {
    std::vector<Parameter> rows;
    for (const std::vector<Parameter>& more :
         {world_rows(), sea_parameters(), grid_rows(), extra_wave_parameters(), wake_sections(),
          view_parameters(), bookmark_parameters(), sky_parameters(), terrain_parameters(),
          light_parameters(), mesh_parameters(), highlight_parameters(), body_parameters(),
          cloud_parameters()}) {
      rows.insert(rows.end(), more.begin(), more.end());
    }
    return rows;
  }();
  return table;
}

const Parameter* find_parameter(std::string_view key) {
  for (const Parameter& parameter : parameter_table()) {
    if (parameter.key == key) {
      return &parameter;
    }
  }
  return nullptr;
}

}  // namespace offing::scene
