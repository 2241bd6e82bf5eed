#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;
constexpr auto wakes = &Scene::wakes;
constexpr auto hulls = &WakeScene::hulls;
constexpr auto window = &WakeScene::parameters;
constexpr auto hull = &WakeHullScene::hull;
// What the shaders of the water take (present/passes/water/wakes.glsl).
constexpr std::size_t max_wakes = 4;
constexpr std::size_t max_hulls = 64;

std::vector<Parameter> window_rows() {
  using ocean::WakeParameters;
  using ocean::WakeRain;
  constexpr auto rain = &WakeParameters::rain;
  return rows_of_section(
      section_of_list<wakes>, ParameterGroup::wake, max_wakes,
      {
          {.key = "ocean.wake.method",
           .storage = choice_at<&element<wakes, window, &WakeParameters::method>>({"dispersive", "verlet"}),
           .help = "how its waves move: dispersive as waves of water do, verlet all at speed_mps"},
          {.key = "ocean.wake.length_m",
           .storage = &element<wakes, window, &WakeParameters::length_m>,
           .unit = "m",
           .low = 0.5,
           .high = 1e5,
           .help = "side of the square window; waves die away in its border, an eighth of it wide"},
          {.key = "ocean.wake.cells",
           .storage = &element<wakes, window, &WakeParameters::cells>,
           .low = 16.0,
           .high = 4096.0,
           .help = "along a side, a power of two; the same in all windows",
           .rule = ParameterRule::power_of_two},
          {.key = "ocean.wake.speed_mps",
           .storage = &element<wakes, window, &WakeParameters::speed_mps>,
           .unit = "m/s",
           .low = 0.01,
           .high = 100.0,
           .help = "of all waves of verlet"},
          {.key = "ocean.wake.centre",
           .storage = choice_at<&element<wakes, &WakeScene::centre>>({"place", "hull", "camera", "body"}),
           .help = "what the window follows: the place x_m, z_m, its first hull, the eye, or a [[body]]"},
          {.key = "ocean.wake.x_m",
           .storage = &element<wakes, &WakeScene::x_m>,
           .unit = "m",
           .low = -1e7,
           .high = 1e7,
           .help = "its centre, east of the origin or of the eye",
           .motion = keyed},
          {.key = "ocean.wake.z_m",
           .storage = &element<wakes, &WakeScene::z_m>,
           .unit = "m",
           .low = -1e7,
           .high = 1e7,
           .help = "its centre, south of the origin or of the eye",
           .motion = keyed},
          {.key = "ocean.wake.behind_m",
           .storage = &element<wakes, &WakeScene::behind_m>,
           .unit = "m",
           .low = -1e5,
           .high = 1e5,
           .help = "how far its centre is behind its first hull, or behind the body"},
          {.key = "ocean.wake.body",
           .storage = &element<wakes, &WakeScene::body>,
           .help = "name of the [[body]] that it follows where its centre is that of a body",
           .example = "ship",
           .absent = "the first body",
           .rule = ParameterRule::name},
          {.key = "ocean.wake.history_s",
           .storage = &element<wakes, &WakeScene::history_s>,
           .unit = "s",
           .low = 0.0,
           .high = 3600.0,
           .help = "for how long the first picture's wake has been growing, and that after a leap in time",
           .slider = {{0.0, 60.0}}},
          {.key = "ocean.wake.step_s",
           .storage = &element<wakes, window, &WakeParameters::step_s>,
           .unit = "s",
           .low = 0.001,
           .high = 0.1,
           .help = "time step; waves of dispersive are exact at any",
           .slider = {{0.01, 0.1}}},
          {.key = "ocean.wake.rain_per_m2s",
           .storage = &element<wakes, window, rain, &WakeRain::drops_per_m2s>,
           .unit = "1/(m2 s)",
           .low = 0.0,
           .high = 1e4,
           .help = "raindrops; at most one a step on each square of 8 by 8 cells"},
          {.key = "ocean.wake.hollow_m",
           .storage = &element<wakes, window, rain, &WakeRain::hollow_m>,
           .unit = "m",
           .low = -1.0,
           .high = 1.0,
           .help = "depth of the hollow that a raindrop leaves, about 3 cells wide"},
      });
}

std::vector<Parameter> hull_rows() {
  using ocean::WakeHull;
  return rows_of_section(
      section_of_inner_list<wakes, hulls>, ParameterGroup::wake_hull, max_hulls,
      {
          {.key = "ocean.wake.hull.shape",
           .storage =
               choice_at<&inner_element<wakes, hulls, hull, &WakeHull::shape>>({"ellipsoid", "gaussian"}),
           .help = "of what it displaces: the lower half of an ellipsoid, or a bell"},
          {.key = "ocean.wake.hull.length_m",
           .storage = &inner_element<wakes, hulls, hull, &WakeHull::length_m>,
           .unit = "m",
           .low = 0.01,
           .high = 1e4,
           .help = "of its waterline"},
          {.key = "ocean.wake.hull.beam_m",
           .storage = &inner_element<wakes, hulls, hull, &WakeHull::beam_m>,
           .unit = "m",
           .low = 0.01,
           .high = 1e4,
           .help = "width of its waterline"},
          {.key = "ocean.wake.hull.draught_m",
           .storage = &inner_element<wakes, hulls, hull, &WakeHull::draught_m>,
           .unit = "m",
           .low = 0.0,
           .high = 100.0,
           .help = "depth of its keel below the water",
           .motion = keyed},
          {.key = "ocean.wake.hull.x_m",
           .storage = &inner_element<wakes, hulls, hull, &WakeHull::x_m>,
           .unit = "m",
           .low = -1e7,
           .high = 1e7,
           .help = "its middle at time 0, east of the origin",
           .motion = keyed},
          {.key = "ocean.wake.hull.z_m",
           .storage = &inner_element<wakes, hulls, hull, &WakeHull::z_m>,
           .unit = "m",
           .low = -1e7,
           .high = 1e7,
           .help = "its middle at time 0, south of the origin",
           .motion = keyed},
          {.key = "ocean.wake.hull.heading_deg",
           .storage = &inner_element<wakes, hulls, hull, &WakeHull::heading_rad>,
           .unit = "deg",
           .low = -360.0,
           .high = 360.0,
           .help = "where its bow points, from +x (east) toward +z (south)",
           .scale = radians_per_degree,
           .motion = keyed_angle},
          {.key = "ocean.wake.hull.speed_mps",
           .storage = &inner_element<wakes, hulls, &WakeHullScene::speed_mps>,
           .unit = "m/s",
           .low = -50.0,
           .high = 50.0,
           .help = "along its heading, added to x_m and z_m; 0 where these have keyframes"},
      });
}

}  // namespace

std::vector<Parameter> wake_sections() {
  std::vector<Parameter> rows = window_rows();
  const std::vector<Parameter> of_hulls = hull_rows();
  rows.insert(rows.end(), of_hulls.begin(), of_hulls.end());
  return rows;
}

}  // namespace offing::scene
