#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

constexpr auto sun = &ViewScene::sun_direction;
constexpr auto air = &ViewScene::atmosphere;

std::string needs_date(const UseContext&, const ViewScene& view) {
  return view.sun_time_utc ? "" : "sun.time_utc is not given";
}

std::vector<Row<ViewScene>> sun_rows() {
  using enum ParameterMotion;
  return {
      {path(sun, &sky::SunAngles::azimuth_rad),
       {.key = "azimuth_deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "direction of the sun, clockwise from north",
        .scale = radians_per_degree,
        .instead_of = "time_utc",
        .motion = keyed_angle}},
      {path(sun, &sky::SunAngles::elevation_rad),
       {.key = "elevation_deg",
        .unit = "deg",
        .low = -90.0,
        .high = 90.0,
        .help = "height of the sun above the horizon",
        .scale = radians_per_degree,
        .instead_of = "time_utc",
        .motion = keyed}},
      {&ViewScene::sun_time_utc,
       {.key = "time_utc",
        .help = "date and time at scene time 0; puts the sun where it is then, seen from world.latitude_deg "
                "and world.longitude_deg",
        .example = "2024-06-21T12:00Z",
        .absent = "none: azimuth_deg and elevation_deg apply"}},
      {&ViewScene::sun_time_scale,
       {.key = "time_scale",
        .low = 0.0,
        .high = 3600.0,
        .help = "speed of the sun: 0 it stands still, 1 real time, 600 a day in 144 s"},
       needs_date},
  };
}

/// Ranges are those that the tables of the clear sky are made for (sky::require_valid()).
std::vector<Row<ViewScene>> air_rows() {
  using enum ParameterMotion;
  return {
      {path(air, &sky::Atmosphere::aerosol_optical_depth),
       {.key = "aerosol_optical_depth",
        .low = 0.0,
        .high = 2.0,
        .help = "optical depth of haze, straight up: 0.06 clean sea air, 0.2 hazy, 0.5 smoke or dust",
        .motion = keyed}},
      {path(air, &sky::Atmosphere::aerosol_scale_height_m),
       {.key = "aerosol_scale_height_m",
        .unit = "m",
        .low = 500.0,
        .high = 50e3,
        .help = "height over which haze thins to 1/e",
        .motion = keyed}},
      {path(air, &sky::Atmosphere::aerosol_albedo),
       {.key = "aerosol_albedo",
        .low = 0.0,
        .high = 1.0,
        .help = "share of light that haze scatters instead of absorbing: 0.97 sea salt, 0.85 soot",
        .motion = keyed}},
      {path(air, &sky::Atmosphere::aerosol_asymmetry),
       {.key = "aerosol_asymmetry",
        .low = -0.95,
        .high = 0.95,
        .help = "how strongly haze scatters forward, into a glow around the sun: 0 equally in all directions",
        .motion = keyed}},
      {&ViewScene::ozone_du,
       {.key = "ozone_du",
        .unit = "DU",
        .low = 0.0,
        .high = 1000.0,
        .help = "ozone, straight up, in Dobson units; it keeps the sky blue at dusk",
        .motion = keyed}},
      {&ViewScene::pressure_pa,
       {.key = "pressure_pa",
        .unit = "Pa",
        .low = 10e3,
        .high = 120e3,
        .help = "air pressure at sea level: sets how much air scatters, and how much it refracts the sun of "
                "time_utc",
        .motion = keyed}},
      {&ViewScene::ground_albedo,
       {.key = "ground_albedo",
        .low = 0.0,
        .high = 1.0,
        .help = "share of light that the distant surface reflects up, the same for all colours",
        .example = "0.3",
        .absent = "as clear sea water, about 0.05"}},
  };
}

}  // namespace

Schema<ViewScene> sun_schema() {
  Schema<ViewScene> schema("sun");
  return schema.rows(ParameterGroup::sun, Affects::view, sun_rows());
}

Schema<ViewScene> sky_schema() {
  Schema<ViewScene> schema("sky");
  return schema.rows(ParameterGroup::sky, Affects::view, air_rows());
}

}  // namespace offing::scene
