#include "host/world/world.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/clouds/particles/particle_motion.h"
#include "host/clouds/particles/particle_thinning.h"
#include "host/world/cloud_light.h"

namespace offing::world {
namespace {

constexpr double sea_radius_m = 6.36e6;  // as the water is drawn: present/passes/water/water.glsl

/// First one motion, then another.
highlights::RigidMotion after(const highlights::RigidMotion& first, const highlights::RigidMotion& then) {
  return {.rotation = then.rotation * first.rotation,
          .translation_m = then.rotation * first.translation_m + then.translation_m};
}

}  // namespace

World::World(const ocl::Device& device, const WorldParameters& parameters)
    : device_(device), parameters_(parameters), sky_(device, parameters.atmosphere) {
  make_sea(parameters);
  set_wakes(parameters.wakes);
  if (parameters.terrain) terrain_.emplace(device, *parameters.terrain);
  make_shoals();
  set_clouds(parameters.clouds);
  set_meshes(parameters.meshes);
  set_bodies(parameters.bodies, parameters.run_up_s);
  set_lights(parameters.lights);
}

ocean::Ocean& World::ocean() {
  if (ocean_) return *ocean_;
  throw Error(ErrorKind::bad_usage, "world: expected a sea, found only terrain",
              "add an [ocean] section to the scene");
}

void World::set_sun(const sky::Sun& sun) {
  parameters_.sun = sun;
  sky_altitude_m_.reset();
  cloud_illumination_.clear();
}

void World::set_atmosphere(const sky::Atmosphere& atmosphere) {
  sky_ = sky::ClearSky(device_, atmosphere);
  parameters_.atmosphere = atmosphere;
  sky_altitude_m_.reset();
  cloud_sky_.reset();
  cloud_illumination_.clear();
}

void World::set_terrain(const std::optional<TerrainParameters>& terrain) {
  if (terrain == parameters_.terrain) return;
  const bool is_same_shape = terrain && terrain_ && terrain->map == terrain_->parameters().map &&
                             terrain->tiles == terrain_->parameters().tiles &&
                             terrain->origin_x_m == terrain_->parameters().origin_x_m &&
                             terrain->origin_z_m == terrain_->parameters().origin_z_m;
  if (is_same_shape) {
    terrain_->set_cover(*terrain);
  } else if (terrain) {
    terrain_ = WorldTerrain(device_, *terrain);
  } else {
    terrain_.reset();
  }
  parameters_.terrain = terrain;
  level_ground_below_meshes();
  if (!is_same_shape) {
    bed_.reset();
    make_shoals();
  }
  sky_altitude_m_.reset();
}

void World::set_sea_level(double level_m) {
  if (level_m == parameters_.sea_level_m) return;
  parameters_.sea_level_m = level_m;
  bed_.reset();
  make_shoals();
  if (bodies_) bodies_->set_level(level_m);
  move_meshes_with_bodies();
  sky_altitude_m_.reset();
  cloud_illumination_.clear();
}

void World::set_clouds(const std::optional<CloudSkyParameters>& clouds) {
  if (clouds && clouds_) {
    clouds_->set(*clouds);
  } else if (clouds) {
    WorldClouds made(device_, *clouds);
    made.set_light_lag(lag_);
    made.set_particle_halvings(cloud_halvings_);
    clouds_ = std::move(made);
  } else {
    clouds_.reset();
    cloud_sky_.reset();
  }
  parameters_.clouds = clouds;
  cloud_illumination_.clear();
}

void World::set_meshes(const std::vector<MeshParameters>& meshes) {
  std::vector<WorldMesh> views;
  for (const MeshParameters& mesh : meshes) views.emplace_back(device_, mesh);
  meshes_ = std::move(views);
  parameters_.meshes = meshes;
  move_meshes_with_bodies();
  level_ground_below_meshes();
}

void World::set_bodies(const std::vector<BodySettings>& bodies, double run_up_s,
                       const std::vector<std::optional<std::size_t>>& before) {
  std::shared_ptr<WorldBodies> made;
  if (ocean_ && !bodies.empty()) {
    // At time 0 a fresh world has bodies at their starts, after a run-up of their own.
    const bool go_on = !before.empty() && time_s_ > 0.0;
    const BodiesBefore going_on{go_on ? bodies_.get() : nullptr, before};
    made = std::make_shared<WorldBodies>(device_, bodies, body_sea(), run_up_s, time_s_, going_on);
  }
  const bool has_other_wakes = made || bodies_;
  bodies_ = std::move(made);
  parameters_.bodies = bodies;
  parameters_.run_up_s = run_up_s;
  if (has_other_wakes) set_wakes(parameters_.wakes);
  move_meshes_with_bodies();
}

void World::keep_bodies(std::shared_ptr<WorldBodies> bodies) {
  if (!bodies_ || !bodies) return;
  bodies_ = std::move(bodies);
  bodies_->set_sea(body_sea());
  renumber_body_meshes(std::vector(parameters_.bodies));
}

void World::renumber_body_meshes(const std::vector<BodySettings>& bodies) {
  parameters_.bodies = bodies;
  for (std::size_t i = 0; bodies_ && i < bodies.size(); ++i)
    bodies_->set_meshes(i, bodies[i].mesh, bodies[i].aboard);
  move_meshes_with_bodies();
}

void World::move_meshes_with_bodies() {
  for (std::size_t i = 0; i < meshes_.size(); ++i) meshes_[i].set_motion(parameters_.meshes[i].motion);
  if (!bodies_) return;
  for (std::size_t body = 0; body < bodies_->size(); ++body) {
    const BodySettings& settings = bodies_->settings()[body];
    const auto hull = bodies_->motion_of_hull(body);
    const auto carry = [&](std::size_t mesh, const std::function<highlights::RigidMotion(double)>& own) {
      meshes_[mesh].set_motion([hull, own](double time_s) { return after(own(time_s), hull(time_s)); });
    };
    // Where meshes have gone, bodies are told a little later.
    if (settings.mesh < meshes_.size())
      carry(settings.mesh, [in_hull = settings.mesh_in_hull](double) { return in_hull; });
    for (const std::size_t mesh : settings.aboard) {
      if (mesh < meshes_.size()) carry(mesh, parameters_.meshes[mesh].motion);
    }
  }
}

void World::level_ground_below_meshes() {
  if (!terrain_ || terrain_->parameters().relief == 0.0) return;
  // What is higher above the ground than its relief flies; what is wider is a landscape of its own.
  constexpr double standing_m = 1.0, flying_m = 4.0, widest_m = 100.0;
  std::vector<terrain::LevelDisc> discs;
  for (const WorldMesh& mesh : meshes_) {
    if (!mesh.is_visible()) continue;
    const MeshFootprint footprint = mesh.footprint_at(time_s_);
    if (footprint.radius_m > widest_m) continue;
    const terrain::TiledField* tiles = terrain_->tiles();
    if (tiles != nullptr &&
        footprint.bottom_m - tiles->coarse_height_m(footprint.middle_m.x, footprint.middle_m.y) >= flying_m)
      continue;
    // Last, as it may read a tile.
    const auto ground = terrain_->terrain_at(footprint.middle_m.x, footprint.middle_m.y);
    if (!ground) continue;
    const double above_m = footprint.bottom_m - ground->height_m;
    const double share = std::clamp((flying_m - above_m) / (flying_m - standing_m), 0.0, 1.0);
    if (share > 0.0) discs.push_back({footprint.middle_m.x, footprint.middle_m.y, footprint.radius_m, share});
  }
  terrain_->set_level_discs(std::move(discs));
}

void World::set_lights(const std::vector<Light>& lights) {
  if (lights.size() > most_lights) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("lights: expected at most {}, found {}", most_lights, lights.size()),
                "remove some");
  }
  parameters_.lights = lights;
}

highlights::Lighting World::lighting(const glm::dvec3& eye_m) const {
  highlights::Lighting lighting{.eye = {.kind = highlights::Source::Kind::place, .vector = eye_m},
                                .lights = {}};
  for (const Light& light : parameters_.lights) lighting.lights.push_back(light.source);
  const auto& [x, y, z] = parameters_.sun.sun_direction;
  if (y > 0.0) lighting.lights.push_back({.vector = {x, y, z}});
  return lighting;
}

void World::see_meshes(const glm::dvec3& eye_m, const highlights::LightingAt& lighting_at,
                       std::optional<double> first_s) {
  for (WorldMesh& mesh : meshes_) {
    if (lighting_at) {
      mesh.at(time_s_, lighting_at, first_s);
    } else {
      mesh.follow(time_s_, lighting(eye_m));
    }
  }
}

void World::look_at_sky(double eye_height_m) {
  const double eye_altitude_m = eye_height_m - parameters_.sea_level_m;
  // Fixed heights, so that a frame does not depend on those before it.
  const double steps = std::round(std::log(std::max(eye_altitude_m, 1.0)) / lag_.altitude_share);
  const double altitude_m = std::exp(steps * lag_.altitude_share);
  if (sky_altitude_m_ == altitude_m) return;
  sky_.at(parameters_.sun, altitude_m);
  illuminance_ = sky_.read_illuminance();
  if (terrain_) {
    terrain_light_ = terrain_light(illuminance_, parameters_.atmosphere, terrain_->parameters().lines,
                                   parameters_.sea_level_m);
  }
  sky_altitude_m_ = altitude_m;
}

void World::at(double time_s, double eye_height_m) {
  if (terrain_) terrain_->set_time(time_s);
  look_at_sky(eye_height_m);
  if (ocean_) {
    ocean_->at(time_s);
    ocean_->foam_map();
    if (bodies_) bodies_->reach(time_s);
    if (wakes_) wakes_->at(time_s, eye_, bodies_.get());
  }
  light_clouds(time_s);
  time_s_ = time_s;
  level_ground_below_meshes();
}

void World::light_clouds(double time_s) {
  if (!clouds_) return;
  if (!cloud_sky_) cloud_sky_.emplace(device_, parameters_.atmosphere);
  const std::vector<clouds::CloudParameters>& all = parameters_.clouds->clouds;
  if (cloud_illumination_.empty()) {
    std::vector<double> altitudes_m;
    for (const clouds::CloudParameters& cloud : all)
      altitudes_m.push_back(cloud.position_m.y - parameters_.sea_level_m);
    cloud_illumination_ =
        cloud_illumination(*cloud_sky_, parameters_.atmosphere, parameters_.sun, altitudes_m);
  }
  clouds_->at(time_s);
  if (parameters_.clouds->light_model == clouds::LightModel::calibrated) {
    std::vector<glm::dvec3> places_m;
    for (const clouds::CloudParameters& cloud : all)
      places_m.push_back(clouds::cloud_origin_m(cloud, clouds_->lit_at_s()));
    clouds_->light(with_lights(cloud_illumination_, parameters_.lights, places_m));
  } else {
    clouds_->light(cloud_illumination_);  // Harris has one sun (clouds::ParticleLight)
  }
  if (parameters_.clouds->throws_shadows && (ocean_ || terrain_ || !meshes_.empty())) clouds_->cast_shadow();
}

void World::set_light_lag(const LightLag& lag) {
  lag_ = lag;
  if (clouds_) clouds_->set_light_lag(lag);
}

void World::set_cloud_halvings(int halvings) {
  clouds::require_halvings(halvings);
  if (clouds_) clouds_->set_particle_halvings(halvings);
  cloud_halvings_ = halvings;
}

void World::see_clouds(const Camera& camera) {
  if (clouds_) clouds_->see(camera);
}

void World::see_mirrored_clouds(const Camera& mirrored) {
  if (clouds_) clouds_->see_mirrored(mirrored, parameters_.sea_level_m);
}

void World::see_terrain(const Camera& camera, const terrain::Sampling& sampling, TileWait wait) {
  if (!terrain_) return;
  terrain::SeaOverTerrain sea;
  const double waves_m = reach().vertical_m, level_m = parameters_.sea_level_m;
  // From above the crests, what is deeper than the troughs is behind water, which falls away as the Earth
  // bends. Where the water is a film over it, it is seen as sharply as on land.
  constexpr double film_m = 0.3;
  if (ocean_ && camera.eye_m.y > level_m + waves_m)
    sea = {.below_m = level_m - waves_m - film_m, .bend_perm = 0.5 / sea_radius_m};
  const std::optional<terrain::CloudShade> shade = shade_of_clouds(camera);
  terrain_->at(camera, sky_, {light_on_terrain(camera), shade ? &*shade : nullptr}, sampling, wait, sea);
}

void World::see_mirrored_terrain(const Camera& mirrored) {
  if (!terrain_ || !ocean_) return;
  const std::optional<terrain::CloudShade> shade = shade_of_clouds(mirrored);
  terrain_->mirror_at(mirrored, parameters_.sea_level_m, sky_,
                      {light_on_terrain(mirrored), shade ? &*shade : nullptr});
}

void World::see_terrain_beneath(const Camera& camera) {
  if (!terrain_ || !ocean_) return;
  const std::optional<terrain::CloudShade> shade = shade_of_clouds(camera);
  const double level_m = parameters_.sea_level_m;
  const double seen_m = ocean::visible_depth_m(ocean::water_optics(parameters_.water));
  terrain_->beneath_at(camera, sky_, {light_on_terrain(camera), shade ? &*shade : nullptr},
                       {.below_m = level_m - reach().vertical_m - seen_m,
                        .bend_perm = 0.5 / sea_radius_m,
                        .above_m = level_m + reach().vertical_m});
}

TerrainLight World::light_on_terrain(const Camera& camera) const {
  TerrainLight light = terrain_light_;
  if (!swash_) return light;
  light.swash = swash_->at(camera.eye_m.x, camera.eye_m.z, time_s_);
  light.still_water_m = static_cast<float>(parameters_.sea_level_m);
  return light;
}

std::optional<terrain::CloudShade> World::shade_of_clouds(const Camera& camera) const {
  if (!clouds_ || clouds_->shadow() == nullptr) return std::nullopt;
  return terrain::CloudShade{clouds_->shadow_about({camera.eye_m.x, 0.0, camera.eye_m.z}),
                             clouds_->shadow()->map()};
}

}  // namespace offing::world
