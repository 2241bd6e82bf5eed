#include "host/scene/world_scene.h"

#include <algorithm>
#include <utility>

#include "host/scene/moving_view.h"
#include "host/scene/parameter_table.h"
#include "host/sky/sun_position.h"

namespace offing::scene {

namespace {

/// What of a sea two scenes differ in, from the least work to the most.
enum class SeaChange { none, waves_beside, seed, all };

SeaChange change_of(const Parameter& row) {
  switch (row.group) {
    case ParameterGroup::camera:
    case ParameterGroup::sun:
    case ParameterGroup::sky:
    case ParameterGroup::render:
      return SeaChange::none;
    case ParameterGroup::swell:
    case ParameterGroup::raindrop:
      return SeaChange::waves_beside;
    case ParameterGroup::world:
      return row.key == "world.seed" ? SeaChange::seed : SeaChange::none;
    case ParameterGroup::time:
      return row.key == "time.loop_period_s" ? SeaChange::all : SeaChange::none;
    case ParameterGroup::wind:
    case ParameterGroup::sea:
    case ParameterGroup::grid:
    case ParameterGroup::foam:
      return SeaChange::all;
  }
  return SeaChange::all;
}

SeaChange sea_change(const OceanScene& before, const OceanScene& after) {
  SeaChange change = SeaChange::none;
  for (const Parameter& row : parameter_table()) {
    if (change_of(row) > change &&
        value_text(before, row, Digits::exact) != value_text(after, row, Digits::exact)) {
      change = change_of(row);
    }
  }
  return change;
}

/// The trochoids of a world whose scene has other swells and raindrops now.
ocean::TrochoidSea with_waves_beside(ocean::TrochoidSea trochoids, const OceanScene& before,
                                     const OceanScene& after) {
  trochoids.waves.resize(trochoids.waves.size() - before.swells.size());
  const std::vector<ocean::Trochoid> swells = swells_of(after, trochoids.dispersion);
  trochoids.waves.insert(trochoids.waves.end(), swells.begin(), swells.end());
  trochoids.raindrops = after.raindrops;
  return trochoids;
}

}  // namespace

world::WorldParameters prepare_world(const OceanScene& scene, Warnings warnings) {
  const OceanScene resolved = with_resolved_wind(scene);
  const ViewScene view = view_at(scene, scene.start_s);
  Sea sea = prepare_sea(scene, warnings);
  ocean::TrochoidSea trochoids = trochoids_of(sea, sea.parameters.seed);
  return {.spectrum = std::move(sea.spectrum),
          .ocean = std::move(sea.parameters),
          .trochoids = std::move(trochoids),
          .wind_speed_mps = resolved.wind_speed_mps,
          .wind_direction_rad = resolved.wind_direction_rad,
          .atmosphere = atmosphere_of(view),
          .sun_direction = sky::direction_of(view.sun_azimuth_rad, view.sun_elevation_rad),
          .sun_distance_au = view.sun_distance_au};
}

void set_view(world::World& world, const ViewScene& view) {
  const world::WorldParameters& now = world.parameters();
  const sky::Atmosphere atmosphere = atmosphere_of(view);
  if (atmosphere != now.atmosphere) world.set_atmosphere(atmosphere);
  const std::array<double, 3> sun = sky::direction_of(view.sun_azimuth_rad, view.sun_elevation_rad);
  if (sun != now.sun_direction || view.sun_distance_au != now.sun_distance_au) {
    world.set_sun(sun, view.sun_distance_au);
  }
}

ViewScene show_at(world::World& world, const OceanScene& scene, double time_s) {
  ViewScene view = view_at(scene, time_s);
  set_view(world, view);
  world.at(time_s, view.camera.eye_m.y);
  return view;
}

void edit_world(world::World& world, const OceanScene& before, const OceanScene& after) {
  const ViewScene view = view_at(after, after.start_s);
  switch (sea_change(before, after)) {
    case SeaChange::none:
      break;
    case SeaChange::waves_beside:
      world.set_trochoids(with_waves_beside(world.parameters().trochoids, before, after));
      break;
    case SeaChange::seed: {
      const Sea sea = prepare_sea(after, Warnings::left_out);
      world.reseed(sea.parameters.seed, trochoids_of(sea, sea.parameters.seed));
      break;
    }
    case SeaChange::all:
      world.set_sea(prepare_world(after, Warnings::left_out));
      break;
  }
  set_view(world, view);
}

}  // namespace offing::scene
