#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

constexpr auto view = &Scene::view;
constexpr auto air = &ViewScene::atmosphere;

std::vector<Parameter> sun_rows() {
  using enum ParameterGroup;
  using enum ParameterMotion;
  return {
      {.key = "sun.azimuth_deg",
       .flag = "",
       .group = sun,
       .storage = &member<view, &ViewScene::sun_azimuth_rad>,
       .unit = "deg",
       .low = -360.0,
       .high = 360.0,
       .help = "where the sun stands, clockwise from north",
       .scale = radians_per_degree,
       .instead_of = "sun.time_utc",
       .motion = keyed_angle},
      {.key = "sun.elevation_deg",
       .flag = "",
       .group = sun,
       .storage = &member<view, &ViewScene::sun_elevation_rad>,
       .unit = "deg",
       .low = -90.0,
       .high = 90.0,
       .help = "how high the sun stands above the horizon",
       .scale = radians_per_degree,
       .instead_of = "sun.time_utc",
       .motion = keyed},
      {.key = "sun.time_utc",
       .flag = "",
       .group = sun,
       .storage = &member<view, &ViewScene::sun_time_utc>,
       .help = "when the scene begins, at time 0: the sun stands where it does then, seen from "
               "world.latitude_deg and world.longitude_deg",
       .example = "2024-06-21T12:00Z",
       .absent = "none: azimuth and elevation are given"},
      {.key = "sun.time_scale",
       .flag = "",
       .group = sun,
       .storage = &member<view, &ViewScene::sun_time_scale>,
       .low = 0.0,
       .high = 3600.0,
       .help = "seconds that pass for the sun in one of the scene: 0 it stands still, 1 it moves as it does, "
               "600 a day in 144 s",
       .use = ParameterUse::dated_sun},
  };
}

/// Ranges are those that the tables of the clear sky are made for (sky::require_valid()).
std::vector<Parameter> air_rows() {
  using enum ParameterGroup;
  using enum ParameterMotion;
  return {
      {.key = "sky.aerosol_optical_depth",
       .flag = "",
       .group = sky,
       .storage = &member<view, air, &sky::Atmosphere::aerosol_optical_depth>,
       .low = 0.0,
       .high = 2.0,
       .help = "haze, straight up: 0.06 clean sea air, 0.2 hazy, 0.5 smoke or dust",
       .motion = keyed},
      {.key = "sky.aerosol_scale_height_m",
       .flag = "",
       .group = sky,
       .storage = &member<view, air, &sky::Atmosphere::aerosol_scale_height_m>,
       .unit = "m",
       .low = 500.0,
       .high = 50e3,
       .help = "height in which haze thins to 1/e",
       .motion = keyed},
      {.key = "sky.aerosol_albedo",
       .flag = "",
       .group = sky,
       .storage = &member<view, air, &sky::Atmosphere::aerosol_albedo>,
       .low = 0.0,
       .high = 1.0,
       .help = "share of what haze takes from a ray that it scatters: 0.97 sea salt, 0.85 soot",
       .motion = keyed},
      {.key = "sky.aerosol_asymmetry",
       .flag = "",
       .group = sky,
       .storage = &member<view, air, &sky::Atmosphere::aerosol_asymmetry>,
       .low = -0.95,
       .high = 0.95,
       .help = "how far haze scatters forward, the glow around the sun: 0 all ways alike",
       .motion = keyed},
      {.key = "sky.ozone_du",
       .flag = "",
       .group = sky,
       .storage = &member<view, &ViewScene::ozone_du>,
       .unit = "DU",
       .low = 0.0,
       .high = 1000.0,
       .help = "ozone, straight up, Dobson units: it keeps the dusk blue",
       .motion = keyed},
      {.key = "sky.pressure_pa",
       .flag = "",
       .group = sky,
       .storage = &member<view, &ViewScene::pressure_pa>,
       .unit = "Pa",
       .low = 10e3,
       .high = 120e3,
       .help = "air pressure at the sea: how much air scatters, and lifts a dated sun by refraction",
       .motion = keyed},
      {.key = "sky.ground_albedo",
       .flag = "",
       .group = sky,
       .storage = &member<view, &ViewScene::ground_albedo>,
       .low = 0.0,
       .high = 1.0,
       .help = "share of light that the far surface sends back up, alike at all colours",
       .example = "0.3",
       .absent = "that of clear sea water, about 0.05"},
  };
}

}  // namespace

std::vector<Parameter> sky_parameters() {
  std::vector<Parameter> rows = sun_rows();
  const std::vector<Parameter> of_air = air_rows();
  rows.insert(rows.end(), of_air.begin(), of_air.end());
  return rows;
}

}  // namespace offing::scene
