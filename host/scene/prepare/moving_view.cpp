#include "host/scene/prepare/moving_view.h"

#include <algorithm>
#include <cmath>

#include "host/base/parameter_check.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/sky/sun_position.h"

namespace offing::scene {

namespace {

/// The sun at a time that is no whole second: between those of the seconds around it, which are so close (15
/// seconds of arc) that the way between them is straight.
sky::SunPosition sun_at(double unix_s, const sky::GeoPosition& position, const sky::Air& air) {
  const double whole_s = std::floor(unix_s);
  const auto second = static_cast<std::int64_t>(whole_s);
  sky::SunPosition sun = sky::sun_position(from_unix_seconds(second), position, air);
  if (unix_s == whole_s) return sun;
  const sky::SunPosition next = sky::sun_position(from_unix_seconds(second + 1), position, air);
  const double part = unix_s - whole_s;
  std::array<double, 3>& to_sun = sun.direction;
  for (std::size_t i = 0; i < 3; ++i) to_sun[i] = std::lerp(to_sun[i], next.direction[i], part);
  sun.azimuth_rad = std::atan2(to_sun[0], -to_sun[2]);
  sun.elevation_rad = std::atan2(to_sun[1], std::hypot(to_sun[0], to_sun[2]));
  sun.distance_au = std::lerp(sun.distance_au, next.distance_au, part);
  return sun;
}

}  // namespace

void move_to(Scene& moment, const Scene& scene, double time_s, std::initializer_list<ParameterGroup> groups) {
  require_within("time_s", time_s, -largest_time_s, largest_time_s);
  for (const auto& [key, track] : scene.tracks) {
    const Parameter& row = *find_parameter(key.key);
    if (std::find(groups.begin(), groups.end(), row.group) == groups.end()) continue;
    *numbers_of(moment, row, key.element)[key.number] = value_at(track, time_s);
  }
}

ViewScene view_at(const Scene& scene, double time_s) {
  using enum ParameterGroup;
  Scene moment;  // rows address values of a whole scene
  moment.view = scene.view;
  move_to(moment, scene, time_s, {camera, sun, sky, render});
  ViewScene& view = moment.view;
  if (view.sun_time_utc) {
    const double unix_s =
        static_cast<double>(unix_seconds(*view.sun_time_utc)) + view.sun_time_scale * time_s;
    const sky::SunPosition sun =
        sun_at(unix_s, {.latitude_rad = scene.world.latitude_rad, .longitude_rad = scene.world.longitude_rad},
               {.pressure_pa = view.pressure_pa});
    view.sun_direction = {sun.azimuth_rad, sun.elevation_rad};
    view.sun_distance_au = sun.distance_au;
  }
  return view;
}

}  // namespace offing::scene
