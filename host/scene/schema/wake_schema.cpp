#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

using enum ParameterMotion;
constexpr auto window = &WakeScene::parameters;
constexpr auto hull = &WakeHullScene::hull;
constexpr std::size_t max_hulls = 64;

std::vector<Row<WakeScene>> window_rows() {
  using ocean::WakeParameters;
  using ocean::WakeRain;
  constexpr auto rain = &WakeParameters::rain;
  return {
      {choice(path(window, &WakeParameters::method), {"dispersive", "verlet"}),
       {.key = "method",
        .help = "how its waves travel: dispersive, as real water waves do, or verlet, all at speed_mps"}},
      {path(window, &WakeParameters::length_m),
       {.key = "length_m",
        .unit = "m",
        .low = 0.5,
        .high = 1e5,
        .help = "side of the square window; its border, an eighth of the side wide, absorbs waves"}},
      {path(window, &WakeParameters::cells),
       {.key = "cells",
        .low = 16.0,
        .high = 4096.0,
        .help = "cells along a side, a power of two; must be the same in all windows",
        .rule = ParameterRule::power_of_two}},
      {path(window, &WakeParameters::speed_mps),
       {.key = "speed_mps",
        .unit = "m/s",
        .low = 0.01,
        .high = 100.0,
        .help = "speed of all waves (verlet)"}},
      {choice(&WakeScene::centre, {"place", "hull", "camera", "body"}),
       {.key = "centre",
        .help = "centre of the window: the place x_m, z_m; its first hull; the camera; or a floating body"}},
      {&WakeScene::x_m,
       {.key = "x_m",
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "centre of the window, east of the origin or of the camera",
        .motion = keyed}},
      {&WakeScene::z_m,
       {.key = "z_m",
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "centre of the window, south of the origin or of the camera",
        .motion = keyed}},
      {&WakeScene::behind_m,
       {.key = "behind_m",
        .unit = "m",
        .low = -1e5,
        .high = 1e5,
        .help = "distance of its centre behind its first hull or its body"}},
      {&WakeScene::body,
       {.key = "body",
        .help = "name of the floating body that it follows, for centre = \"body\"",
        .example = "ship",
        .absent = "the first body",
        .rule = ParameterRule::name}},
      {&WakeScene::history_s,
       {.key = "history_s",
        .unit = "s",
        .low = 0.0,
        .high = 3600.0,
        .help = "age of the wake in the first picture, and after a jump in time",
        .slider = {{0.0, 60.0}}}},
      {path(window, &WakeParameters::step_s),
       {.key = "step_s",
        .unit = "s",
        .low = 0.001,
        .high = 0.1,
        .help = "time step; dispersive waves are exact at any step",
        .slider = {{0.01, 0.1}}}},
      {path(window, &WakeParameters::foam_decay_s),
       {.key = "foam_decay_s",
        .unit = "s",
        .low = 0.0,
        .high = 1000.0,
        .help = "time in which the foam of hulls and of waves that they make fades to 1/e; 0: no foam",
        .slider = {{0.0, 60.0}}}},
      {path(window, rain, &WakeRain::drops_per_m2s),
       {.key = "rain_per_m2s",
        .unit = "1/(m2 s)",
        .low = 0.0,
        .high = 1e4,
        .help = "raindrops per area and time; at most one per step on each square of 8 by 8 cells"}},
      {path(window, rain, &WakeRain::hollow_m),
       {.key = "hollow_m",
        .unit = "m",
        .low = -1.0,
        .high = 1.0,
        .help = "depth of the hollow that a raindrop leaves, about 3 cells wide"}},
  };
}

std::vector<Row<WakeHullScene>> hull_rows() {
  using ocean::WakeHull;
  return {
      {choice(path(hull, &WakeHull::shape), {"ellipsoid", "gaussian"}),
       {.key = "shape",
        .help = "shape of the displaced water: the lower half of an ellipsoid, or a bell (gaussian)"}},
      {path(hull, &WakeHull::length_m),
       {.key = "length_m", .unit = "m", .low = 0.01, .high = 1e4, .help = "length of its waterline"}},
      {path(hull, &WakeHull::beam_m),
       {.key = "beam_m", .unit = "m", .low = 0.01, .high = 1e4, .help = "width of its waterline"}},
      {path(hull, &WakeHull::draught_m),
       {.key = "draught_m",
        .unit = "m",
        .low = 0.0,
        .high = 100.0,
        .help = "depth of its keel below the water",
        .motion = keyed}},
      {path(hull, &WakeHull::x_m),
       {.key = "x_m",
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "its middle at time 0, east of the origin",
        .motion = keyed}},
      {path(hull, &WakeHull::z_m),
       {.key = "z_m",
        .unit = "m",
        .low = -1e7,
        .high = 1e7,
        .help = "its middle at time 0, south of the origin",
        .motion = keyed}},
      {path(hull, &WakeHull::heading_rad),
       {.key = "heading_deg",
        .unit = "deg",
        .low = -360.0,
        .high = 360.0,
        .help = "direction of its bow, from +x (east) toward +z (south)",
        .scale = radians_per_degree,
        .motion = keyed_angle}},
      {&WakeHullScene::speed_mps,
       {.key = "speed_mps",
        .unit = "m/s",
        .low = -50.0,
        .high = 50.0,
        .help = "speed along its heading, added to x_m and z_m; keep 0 where these have keyframes"}},
  };
}

}  // namespace

Schema<WakeScene> wake_schema() {
  constexpr Affects affects = Affects::wakes | Affects::baked;
  Schema<WakeHullScene> hull_schema("hull");
  hull_schema.rows(ParameterGroup::wake_hull, affects, hull_rows());
  Schema<WakeScene> schema("wake");
  return schema.rows(ParameterGroup::wake, affects, window_rows())
      .list(&WakeScene::hulls, max_hulls, hull_schema);
}

}  // namespace offing::scene
