#include "host/scene/prepare/world_scene.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/log.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_bodies.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_terrain.h"
#include "host/scene/prepare/scene_wakes.h"
#include "host/scene/schema/scene_elements.h"
#include "host/scene/schema/unused_parameters.h"

namespace offing::scene {

namespace {

/// What of a sea two scenes differ in, from the least work to the most.
enum class SeaChange { none, waves_beside, wakes, seed, all };

SeaChange sea_change(const Scene& before, const Scene& after) {
  if (before.has_sea() != after.has_sea()) return SeaChange::all;
  if (!after.has_sea()) return SeaChange::none;
  if (differ_in(Affects::spectrum, before, after)) return SeaChange::all;
  if (differ_in(Affects::sea_seed, before, after)) return SeaChange::seed;
  if (differ_in(Affects::wakes, before, after)) return SeaChange::wakes;
  return differ_in(Affects::extra_waves, before, after) ? SeaChange::waves_beside : SeaChange::none;
}

/// The Gerstner waves of a world whose scene has other swells and raindrops now.
ocean::GerstnerSea with_waves_beside(ocean::GerstnerSea gerstner_waves, const Scene& before,
                                     const Scene& after) {
  const auto is_one_wave = [](const SwellScene& swell) { return !swell.hs_m; };
  gerstner_waves.waves.resize(gerstner_waves.waves.size() -
                              std::ranges::count_if(before.ocean.swells, is_one_wave));
  const std::vector<ocean::GerstnerWave> swells = swells_of(after, gerstner_waves.dispersion);
  gerstner_waves.waves.insert(gerstner_waves.waves.end(), swells.begin(), swells.end());
  gerstner_waves.raindrops = after.ocean.raindrops;
  return gerstner_waves;
}

/// All that a world needs of a scene but its ground.
world::WorldParameters prepare_sea_and_sky(const Scene& scene, Warnings warnings) {
  const ViewScene view = view_at(scene, scene.time.start_s);
  world::WorldParameters parameters{
      .has_sea = scene.has_sea(), .atmosphere = atmosphere_of(view), .sun = sun_of(view)};
  if (!parameters.has_sea) {
    if (warnings == Warnings::left_out) return parameters;
    for (const std::string& line : unused_parameters(scene)) spdlog::warn("{}", line);
    return parameters;
  }
  Sea sea = prepare_sea(scene, warnings);
  parameters.wind = sea.wind;
  parameters.wakes = prepare_wakes(scene, sea.spectrum.dispersion);
  parameters.spectrum = std::move(sea.spectrum);
  parameters.ocean = std::move(sea.parameters);
  parameters.water = scene.ocean.water;
  parameters.has_shoals = scene.ocean.shoaling == Shoaling::on;
  parameters.sea_level_m = scene.sea_level_m();
  return parameters;
}

}  // namespace

world::WorldParameters prepare_world(const Scene& scene, Warnings warnings, const Work& work) {
  world::WorldParameters parameters = prepare_sea_and_sky(scene, warnings);
  parameters.terrain = prepare_terrain(scene, work);
  parameters.clouds = prepare_clouds(scene);
  parameters.pictures = prepare_images(scene);
  parameters.meshes = prepare_meshes(scene);
  parameters.bodies = prepare_bodies(scene, parameters.meshes);
  parameters.run_up_s = run_up_s(scene);
  parameters.lights = lights_at(scene, scene.time.start_s);
  return parameters;
}

world::WorldParameters prepare_shown_world(Scene& scene, const Work& work) {
  world::WorldParameters parameters = prepare_world(scene, Warnings::logged, work);
  place_camera(scene, parameters.terrain);
  // The usual eye stands above the sea.
  if (!parameters.terrain && !scene.set_at.contains("camera.y_m"))
    scene.view.camera.eye_m.y += parameters.sea_level_m;
  const bool has_meshes_alone = !parameters.has_sea && !parameters.terrain && !parameters.meshes.empty();
  if (has_meshes_alone && !places_its_camera(scene)) {
    look_at_meshes(parameters.meshes, scene.time.start_s, scene.view.camera);
  }
  return parameters;
}

void set_view(world::World& world, const ViewScene& view) {
  const world::WorldParameters& now = world.parameters();
  const sky::Atmosphere atmosphere = atmosphere_of(view);
  if (atmosphere != now.atmosphere) world.set_atmosphere(atmosphere);
  const sky::Sun sun = sun_of(view);
  if (sun != now.sun) world.set_sun(sun);
}

ViewScene show_at(world::World& world, const Scene& scene, double time_s) {
  ViewScene view = view_at(scene, time_s);
  if (world.terrain()) stand_on_ground(*world.terrain(), view);
  set_view(world, view);
  set_meshes_at(world, scene, time_s);
  world.set_eye({view.camera.eye_m.x, view.camera.eye_m.z});
  world.at(time_s, view.camera.eye_m.y);
  return view;
}

void edit_world_below(world::World& world, const Scene& before, const Scene& after) {
  const ViewScene view = view_at(after, after.time.start_s);
  const std::optional<world::TerrainParameters> terrain =
      edited_terrain(world.parameters().terrain, before, after);
  switch (sea_change(before, after)) {
    case SeaChange::none:
      break;
    case SeaChange::waves_beside:
      world.set_gerstner_waves(with_waves_beside(world.parameters().ocean.gerstner_waves, before, after));
      break;
    case SeaChange::wakes:
      world.set_gerstner_waves(with_waves_beside(world.parameters().ocean.gerstner_waves, before, after));
      world.set_wakes(prepare_wakes(after, world.parameters().spectrum.dispersion));
      break;
    case SeaChange::seed: {
      const Sea sea = prepare_sea(after, Warnings::left_out);
      world.reseed(sea.parameters.seed, sea.parameters.gerstner_waves);
      world.set_wakes(prepare_wakes(after, sea.spectrum.dispersion));
      break;
    }
    case SeaChange::all:
      world.set_sea(prepare_sea_and_sky(after, Warnings::left_out));
      break;
  }
  world.set_water(after.ocean.water);
  world.set_sea_level(after.sea_level_m());
  world.set_terrain(terrain);
  edit_meshes(world, before, after);
  edit_bodies(world, before, after);
  set_view(world, view);
}

void edit_world(world::World& world, const Scene& before, const Scene& after) {
  edit_world_below(world, before, after);
  edit_clouds(world, before, after);
}

}  // namespace offing::scene
