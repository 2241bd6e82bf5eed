#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

/// What shapes the energy of the sea, and with it each baked frame.
constexpr Affects spectrum = Affects::spectrum | Affects::baked;

std::string needs_height(const UseContext&, const SwellScene& swell) {
  return swell.hs_m ? "" : "the swell has no hs_m: it is one wave";
}

std::string needs_amplitude(const UseContext&, const SwellScene& swell) {
  return swell.hs_m ? "the swell has hs_m: it is many waves" : "";
}

}  // namespace

Schema<SwellScene> swell_schema() {
  Schema<SwellScene> schema("swell");
  return schema.rows(
      ParameterGroup::swell, Affects::extra_waves | Affects::baked,
      {
          {&SwellScene::hs_m,
           {.key = "hs_m",
            .affects = spectrum,
            .unit = "m",
            .low = 0.001,
            .high = 30.0,
            .help = "significant height of an irregular swell, in addition to the other waves",
            .example = "1.5",
            .absent = "one wave with parallel crests, of amplitude_m"}},
          {&SwellScene::tp_s,
           {.key = "tp_s",
            .affects = spectrum,
            .unit = "s",
            .low = 1.0,
            .high = 40.0,
            .help = "peak period of an irregular swell; its frequencies have a standard deviation of 6 %",
            .example = "14",
            .absent = "12",
            .instead_of = "period_s"},
           needs_height},
          {&SwellScene::spread_rad,
           {.key = "spread_deg",
            .affects = spectrum,
            .unit = "deg",
            .low = 3.0,
            .high = 75.0,
            .help = "directional spread of an irregular swell: standard deviation of its directions",
            .scale = radians_per_degree},
           needs_height},
          {&SwellScene::amplitude_m,
           {.key = "amplitude_m",
            .unit = "m",
            .low = 0.0,
            .high = 100.0,
            .help = "amplitude of a swell with parallel crests: half its height from trough to crest",
            .instead_of = "hs_m"},
           needs_amplitude},
          {&SwellScene::wavelength_m,
           {.key = "wavelength_m",
            .unit = "m",
            .low = 0.1,
            .high = 1e5,
            .help = "distance from crest to crest of a swell with parallel crests",
            .example = "100",
            .absent = "from period_s; without it, 100"},
           needs_amplitude},
          {&SwellScene::period_s,
           {.key = "period_s",
            .unit = "s",
            .low = 0.3,
            .high = 120.0,
            .help = "time between its crests at a fixed place, in water of the scene's depth",
            .example = "8",
            .absent = "from wavelength_m",
            .instead_of = "wavelength_m"},
           needs_amplitude},
          {&SwellScene::direction_rad,
           {.key = "direction_deg",
            .affects = spectrum | Affects::extra_waves,
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "direction in which it travels, from +x (east) toward +z (south)",
            .scale = radians_per_degree}},
          {&SwellScene::phase_rad,
           {.key = "phase_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "phase at the origin and time 0: 0 a crest, 180 a trough",
            .scale = radians_per_degree},
           needs_amplitude},
      });
}

Schema<ocean::Raindrop> raindrop_schema() {
  using ocean::Raindrop;
  Schema<Raindrop> schema("raindrop");
  return schema.rows(
      ParameterGroup::raindrop, Affects::extra_waves | Affects::baked,
      {
          {&Raindrop::x_m,
           {.key = "x_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "where the drop falls, east of the origin"}},
          {&Raindrop::z_m,
           {.key = "z_m",
            .unit = "m",
            .low = -1e7,
            .high = 1e7,
            .help = "where the drop falls, south of the origin"}},
          {&Raindrop::time_s,
           {.key = "time_s",
            .unit = "s",
            .low = -1e6,
            .high = 1e6,
            .help = "when the drop falls; its ring grows from then on"}},
          {&Raindrop::amplitude_m,
           {.key = "amplitude_m",
            .unit = "m",
            .low = -10.0,
            .high = 10.0,
            .help = "height of the water where and when the drop falls; negative makes a hollow. Above "
                    "wavelength_m / 14 the ring is steeper than real waves can be"}},
          {&Raindrop::wavelength_m,
           {.key = "wavelength_m",
            .unit = "m",
            .low = 0.001,
            .high = 1000.0,
            .help = "distance between crests of its ring, which is about four wavelengths wide"}},
          {&Raindrop::decay_s,
           {.key = "decay_s",
            .unit = "s",
            .low = 0.001,
            .high = 1e5,
            .help = "time in which its ring fades to 1/e, in addition to what it loses as it widens"}},
      });
}

}  // namespace offing::scene
