#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

constexpr auto swells = &Scene::swells;
constexpr auto drops = &Scene::raindrops;
// Of the 128 Gerstner waves that a sea can have, 64 are for the spectrum's long waves.
constexpr std::size_t max_swells = 64;
constexpr std::size_t max_raindrops = 4096;

std::vector<Parameter> swell_parameters() {
  return rows_of_section(section_of_list<swells>, ParameterGroup::swell, max_swells,
                         {
                             {.key = "ocean.swell.amplitude_m",
                              .storage = &element<swells, &SwellScene::amplitude_m>,
                              .unit = "m",
                              .low = 0.0,
                              .high = 100.0,
                              .help = "half the height of a parallel swell, from trough to crest"},
                             {.key = "ocean.swell.wavelength_m",
                              .storage = &element<swells, &SwellScene::wavelength_m>,
                              .unit = "m",
                              .low = 0.1,
                              .high = 1e5,
                              .help = "from crest to crest",
                              .example = "100",
                              .absent = "that of the period; without one, 100"},
                             {.key = "ocean.swell.period_s",
                              .storage = &element<swells, &SwellScene::period_s>,
                              .unit = "s",
                              .low = 0.3,
                              .high = 120.0,
                              .help = "between crests at a fixed place; in water of the scene's depth",
                              .example = "8",
                              .absent = "that of the wavelength",
                              .instead_of = "ocean.swell.wavelength_m"},
                             {.key = "ocean.swell.direction_deg",
                              .storage = &element<swells, &SwellScene::direction_rad>,
                              .unit = "deg",
                              .low = -360.0,
                              .high = 360.0,
                              .help = "direction of travel, from +x (east) toward +z (south)",
                              .scale = radians_per_degree},
                             {.key = "ocean.swell.phase_deg",
                              .storage = &element<swells, &SwellScene::phase_rad>,
                              .unit = "deg",
                              .low = -360.0,
                              .high = 360.0,
                              .help = "at the origin and time 0: 0 a crest, 180 a trough",
                              .scale = radians_per_degree},
                         });
}

std::vector<Parameter> raindrop_parameters() {
  using ocean::Raindrop;
  return rows_of_section(
      section_of_list<drops>, ParameterGroup::raindrop, max_raindrops,
      {
          {.key = "ocean.raindrop.x_m",
           .storage = &element<drops, &Raindrop::x_m>,
           .unit = "m",
           .low = -1e7,
           .high = 1e7,
           .help = "where the drop falls, east of the origin"},
          {.key = "ocean.raindrop.z_m",
           .storage = &element<drops, &Raindrop::z_m>,
           .unit = "m",
           .low = -1e7,
           .high = 1e7,
           .help = "where the drop falls, south of the origin"},
          {.key = "ocean.raindrop.time_s",
           .storage = &element<drops, &Raindrop::time_s>,
           .unit = "s",
           .low = -1e6,
           .high = 1e6,
           .help = "when the drop falls; its ring grows from then on"},
          {.key = "ocean.raindrop.amplitude_m",
           .storage = &element<drops, &Raindrop::amplitude_m>,
           .unit = "m",
           .low = -10.0,
           .high = 10.0,
           .help = "height of the water where the drop falls, when it falls; negative for a hollow; from a "
                   "14th of "
                   "wavelength_m on it is steeper than waves of water"},
          {.key = "ocean.raindrop.wavelength_m",
           .storage = &element<drops, &Raindrop::wavelength_m>,
           .unit = "m",
           .low = 0.001,
           .high = 1000.0,
           .help = "from crest to crest of its ring, which is about four wavelengths wide"},
          {.key = "ocean.raindrop.decay_s",
           .storage = &element<drops, &Raindrop::decay_s>,
           .unit = "s",
           .low = 0.001,
           .high = 1e5,
           .help = "time in which its ring fades to 1/e, beside what it loses as it widens"},
      });
}

}  // namespace

std::vector<Parameter> extra_wave_parameters() {
  std::vector<Parameter> rows = swell_parameters();
  const std::vector<Parameter> of_drops = raindrop_parameters();
  rows.insert(rows.end(), of_drops.begin(), of_drops.end());
  return rows;
}

}  // namespace offing::scene
