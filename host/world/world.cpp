#include "host/world/world.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/world/cloud_light.h"
#include "host/world/sea_bed.h"

namespace offing::world {
namespace {

constexpr double reach_deviations = 6.0;
constexpr std::size_t rings_that_meet = 8;
constexpr double sea_radius_m = 6.36e6;  // as the water is drawn: present/shaders/water.glsl

std::vector<std::vector<float>> variances_of(const ocean::Ocean& ocean) {
  std::vector<std::vector<float>> variances;
  for (std::size_t i = 0; i < ocean.parameters().cascades.size(); ++i) {
    variances.push_back(ocean.mode_variance(static_cast<int>(i)));
  }
  return variances;
}

/// First one motion, then another.
highlights::RigidMotion after(const highlights::RigidMotion& first, const highlights::RigidMotion& then) {
  return {.rotation = then.rotation * first.rotation,
          .translation_m = then.rotation * first.translation_m + then.translation_m};
}

RippleWind ripple_wind(const WorldParameters& parameters) {
  return {.speed_mps = parameters.wind_speed_mps, .direction_rad = parameters.wind_direction_rad};
}

std::vector<ocean::ShoalingBand> bands_of(const std::vector<std::vector<float>>& variances,
                                          const ocean::OceanParameters& ocean) {
  std::vector<ocean::ShoalingBand> bands;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    bands.push_back(ocean::band_of_modes(variances[i], ocean.size, ocean.cascades[i].patch_length_m));
  }
  return bands;
}

double deviation_m(const std::vector<std::vector<float>>& variances) {
  double variance_m2 = 0.0;
  for (const std::vector<float>& modes : variances) {
    variance_m2 = std::accumulate(modes.begin(), modes.end(), variance_m2);
  }
  return std::sqrt(variance_m2);
}

/// Of the tallest rings alone: so many seldom meet in one place, and a scene may have thousands.
double height_of_rings_m(const std::vector<ocean::Raindrop>& drops, double time_s) {
  std::vector<double> heights_m;
  for (const ocean::Raindrop& drop : drops) {
    const double age_s = time_s - drop.time_s;
    if (age_s >= 0.0) heights_m.push_back(std::abs(drop.amplitude_m) * std::exp(-age_s / drop.decay_s));
  }
  const auto counted =
      heights_m.begin() + static_cast<std::ptrdiff_t>(std::min(heights_m.size(), rings_that_meet));
  std::partial_sort(heights_m.begin(), counted, heights_m.end(), std::greater<>());
  return std::accumulate(heights_m.begin(), counted, 0.0);
}

}  // namespace

World::World(const ocl::Device& device, const WorldParameters& parameters)
    : device_(device), parameters_(parameters), sky_(device, parameters.atmosphere) {
  make_sea(parameters);
  set_wakes(parameters.wakes);
  if (parameters.ground) ground_.emplace(device, *parameters.ground);
  make_shoals();
  set_clouds(parameters.clouds);
  set_meshes(parameters.meshes);
  set_bodies(parameters.bodies, parameters.run_up_s);
  set_lamps(parameters.lamps);
}

void World::make_sea(const WorldParameters& parameters) {
  if (!parameters.has_sea) {
    ocean_.reset();
    cascade_bands_.clear();
    hidden_slopes_ = {};
    deviation_m_ = 0.0;
    return;
  }
  ocean::require_valid_trochoids(parameters.trochoids);
  ocean::Ocean made(device_, parameters.spectrum, parameters.ocean);
  const std::vector<std::vector<float>> variances = variances_of(made);
  hidden_slopes_ = shared_out(hidden_by_levels(parameters.ocean, variances), parameters.trochoids.waves,
                              ripple_wind(parameters));
  deviation_m_ = deviation_m(variances);
  cascade_bands_ = bands_of(variances, parameters.ocean);
  ocean_ = std::move(made);
}

void World::make_shoals() {
  std::shared_ptr<const ocean::Shoals> made;
  if (ocean_ && ground_ && parameters_.has_shoals) {
    if (!bed_) bed_ = std::make_shared<const ocean::DepthMap>(sea_bed(ground_->parameters()));
    const ocean::ShoalTable table(parameters_.spectrum.dispersion,
                                  ocean::shoaling_bands(cascade_bands_, parameters_.trochoids.waves));
    if (bed_->shallowest_m() < table.deepest_m()) {
      made = std::make_shared<const ocean::Shoals>(device_, bed_, table);
    }
  }
  shoals_ = std::move(made);
  if (ocean_) ocean_->set_shoals(shoals_);
  if (bodies_) bodies_->set_shoals(shoals_);
}

ocean::Ocean& World::ocean() {
  if (ocean_) return *ocean_;
  throw Error(ErrorKind::bad_usage, "world: expected a sea, found ground alone",
              "add an [ocean] section to the scene");
}

void World::set_sun(const std::array<double, 3>& direction, double distance_au) {
  parameters_.sun_direction = direction;
  parameters_.sun_distance_au = distance_au;
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

void World::set_trochoids(const ocean::TrochoidSea& trochoids) {
  ocean::require_valid_trochoids(trochoids);
  parameters_.trochoids = trochoids;
  hidden_slopes_ =
      shared_out(std::move(hidden_slopes_.cascades), parameters_.trochoids.waves, ripple_wind(parameters_));
  make_shoals();
  if (bodies_) bodies_->set_sea(body_sea());
}

void World::set_wakes(const std::vector<WakeSettings>& wakes) {
  std::optional<WakeView> made;
  if (ocean_ && !wakes.empty()) made.emplace(device_, wakes, time_s_);
  wakes_ = std::move(made);
  if (ocean_) ocean_->set_wakes(wakes_ ? wakes_->maps() : nullptr);
  parameters_.wakes = wakes;
}

void World::reseed(std::uint64_t seed, const ocean::TrochoidSea& trochoids) {
  ocean::require_valid_trochoids(trochoids);
  ocean().reseed(seed);
  parameters_.ocean.seed = seed;
  parameters_.trochoids = trochoids;
  hidden_slopes_ =
      shared_out(std::move(hidden_slopes_.cascades), parameters_.trochoids.waves, ripple_wind(parameters_));
  make_shoals();
  if (bodies_) bodies_->set_sea(body_sea());
}

void World::set_sea(const WorldParameters& parameters) {
  make_sea(parameters);
  parameters_.has_sea = parameters.has_sea;
  parameters_.spectrum = parameters.spectrum;
  parameters_.ocean = parameters.ocean;
  parameters_.trochoids = parameters.trochoids;
  parameters_.wind_speed_mps = parameters.wind_speed_mps;
  parameters_.wind_direction_rad = parameters.wind_direction_rad;
  parameters_.has_shoals = parameters.has_shoals;
  make_shoals();
  set_wakes(parameters.wakes);
  if (bodies_ && has_sea()) {
    bodies_->set_sea(body_sea());
  } else {
    set_bodies(parameters_.bodies, parameters_.run_up_s);
  }
}

void World::set_ground(const std::optional<GroundParameters>& ground) {
  if (ground == parameters_.ground) return;
  const bool is_same_shape = ground && ground_ && ground->map == ground_->parameters().map &&
                             ground->tiles == ground_->parameters().tiles &&
                             ground->origin_x_m == ground_->parameters().origin_x_m &&
                             ground->origin_z_m == ground_->parameters().origin_z_m;
  if (is_same_shape) {
    ground_->set_cover(*ground);
  } else if (ground) {
    ground_ = GroundView(device_, *ground);
  } else {
    ground_.reset();
  }
  parameters_.ground = ground;
  if (!is_same_shape) {
    bed_.reset();
    make_shoals();
  }
  sky_altitude_m_.reset();
}

void World::set_clouds(const std::optional<CloudSkyParameters>& clouds) {
  if (clouds && clouds_) {
    clouds_->set(*clouds);
  } else if (clouds) {
    clouds_.emplace(device_, *clouds);
    clouds_->set_light_lag(lag_);
  } else {
    clouds_.reset();
    cloud_sky_.reset();
  }
  parameters_.clouds = clouds;
  cloud_illumination_.clear();
}

void World::set_meshes(const std::vector<MeshParameters>& meshes) {
  std::vector<MeshView> views;
  for (const MeshParameters& mesh : meshes) views.emplace_back(device_, mesh);
  meshes_ = std::move(views);
  parameters_.meshes = meshes;
  move_meshes_with_bodies();
}

void World::set_bodies(const std::vector<BodySettings>& bodies, double run_up_s) {
  std::unique_ptr<BodyView> made;
  if (ocean_ && !bodies.empty()) {
    made = std::make_unique<BodyView>(device_, bodies, body_sea(), run_up_s, time_s_);
  }
  const bool has_other_wakes = made || bodies_;
  bodies_ = std::move(made);
  parameters_.bodies = bodies;
  parameters_.run_up_s = run_up_s;
  if (has_other_wakes) set_wakes(parameters_.wakes);
  move_meshes_with_bodies();
}

void World::move_meshes_with_bodies() {
  for (std::size_t i = 0; i < meshes_.size(); ++i) meshes_[i].set_motion(parameters_.meshes[i].motion);
  if (!bodies_) return;
  for (std::size_t body = 0; body < bodies_->size(); ++body) {
    const BodySettings& settings = bodies_->settings()[body];
    const auto hull = bodies_->motion_of_hull(body);
    const auto carry = [&](std::size_t mesh, const std::function<highlights::RigidMotion(double)>& own) {
      if (mesh >= meshes_.size()) return;
      meshes_[mesh].set_motion([hull, own](double time_s) { return after(own(time_s), hull(time_s)); });
    };
    carry(settings.mesh, [in_hull = settings.mesh_in_hull](double) { return in_hull; });
    for (const std::size_t mesh : settings.aboard) carry(mesh, parameters_.meshes.at(mesh).motion);
  }
}

void World::set_lamps(const std::vector<Lamp>& lamps) {
  if (lamps.size() > most_lamps) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("lamps: expected at most {}, found {}", most_lamps, lamps.size()),
                "take some away");
  }
  parameters_.lamps = lamps;
}

highlights::Lighting World::lighting(const glm::dvec3& eye_m) const {
  highlights::Lighting lighting{.eye = {.kind = highlights::Source::Kind::place, .vector = eye_m},
                                .lamps = {}};
  for (const Lamp& lamp : parameters_.lamps) lighting.lamps.push_back(lamp.source);
  const auto& [x, y, z] = parameters_.sun_direction;
  if (y > 0.0) lighting.lamps.push_back({.vector = {x, y, z}});
  return lighting;
}

void World::see_meshes(const glm::dvec3& eye_m, const highlights::LightingAt& lighting_at,
                       std::optional<double> first_s) {
  for (MeshView& mesh : meshes_) {
    if (lighting_at) {
      mesh.at(time_s_, lighting_at, first_s);
    } else {
      mesh.follow(time_s_, lighting(eye_m));
    }
  }
}

ocean::SurfaceReach World::reach() const {
  if (!ocean_) return {};
  const double growth = shoals_ ? shoals_->instant().table.largest_share() : 1.0;
  const double waves_m = growth * reach_deviations * deviation_m_;
  double trochoids_m = 0.0;
  for (const ocean::Trochoid& wave : parameters_.trochoids.waves) trochoids_m += growth * wave.amplitude_m;
  return {.horizontal_m = parameters_.ocean.choppiness * waves_m +
                          ocean::horizontal_scale(parameters_.trochoids).scale * trochoids_m,
          .vertical_m = waves_m + trochoids_m + height_of_rings_m(parameters_.trochoids.raindrops, time_s_) +
                        (wakes_ ? wakes_->reach_m(time_s_) : 0.0) +
                        (wakes_ && bodies_ ? bodies_->draught_m() : 0.0)};
}

void World::look_at_sky(double eye_altitude_m) {
  // Fixed heights, so that a frame does not depend on those before it.
  const double steps = std::round(std::log(std::max(eye_altitude_m, 1.0)) / lag_.altitude_share);
  const double altitude_m = std::exp(steps * lag_.altitude_share);
  if (sky_altitude_m_ == altitude_m) return;
  sky_.at({.sun_direction = parameters_.sun_direction,
           .sun_distance_au = parameters_.sun_distance_au,
           .eye_altitude_m = altitude_m});
  illuminance_ = sky_.read_illuminance();
  if (ground_) {
    ground_light_ = terrain_light(illuminance_, parameters_.atmosphere, ground_->parameters().lines);
  }
  sky_altitude_m_ = altitude_m;
}

void World::at(double time_s, double eye_altitude_m) {
  look_at_sky(eye_altitude_m);
  if (ocean_) {
    ocean_->at(time_s);
    ocean_->foam_map();
    if (bodies_) bodies_->reach(time_s);
    if (wakes_) wakes_->at(time_s, eye_, bodies_.get());
  }
  light_clouds(time_s);
  time_s_ = time_s;
}

void World::light_clouds(double time_s) {
  if (!clouds_) return;
  if (!cloud_sky_) cloud_sky_.emplace(device_, parameters_.atmosphere);
  if (cloud_illumination_.empty()) {
    cloud_illumination_ =
        cloud_illumination(*cloud_sky_, parameters_.atmosphere,
                           {parameters_.sun_direction, parameters_.sun_distance_au}, clouds_->altitudes_m());
  }
  clouds_->at(time_s);
  clouds_->light(cloud_illumination_);
  if (parameters_.clouds->throws_shadows && (ocean_ || ground_ || !meshes_.empty())) clouds_->cast_shadow();
}

void World::set_light_lag(const LightLag& lag) {
  lag_ = lag;
  if (clouds_) clouds_->set_light_lag(lag);
}

void World::see_clouds(const Camera& camera) {
  if (clouds_) clouds_->see(camera);
}

void World::see_ground(const Camera& camera, const terrain::Sampling& sampling, TileWait wait) {
  if (!ground_) return;
  terrain::SeaOverGround sea;
  const double waves_m = reach().vertical_m;
  // From above the crests, what is deeper than the troughs is behind water, which falls away as the Earth
  // bends.
  if (ocean_ && camera.eye_m.y > waves_m) sea = {-waves_m, 0.5 / sea_radius_m};
  const std::optional<terrain::CloudShade> shade = shade_of_clouds(camera);
  ground_->at(camera, sky_, {ground_light_, shade ? &*shade : nullptr}, sampling, wait, sea);
}

void World::see_mirrored_ground(const Camera& mirrored) {
  if (!ground_ || !ocean_) return;
  const std::optional<terrain::CloudShade> shade = shade_of_clouds(mirrored);
  ground_->mirror_at(mirrored, sky_, {ground_light_, shade ? &*shade : nullptr});
}

void World::see_ground_beneath(const Camera& camera) {
  if (!ground_ || !ocean_) return;
  const std::optional<terrain::CloudShade> shade = shade_of_clouds(camera);
  const double seen_m = ocean::visible_depth_m(ocean::water_optics(parameters_.water));
  ground_->beneath_at(camera, sky_, {ground_light_, shade ? &*shade : nullptr},
                      {-reach().vertical_m - seen_m, 0.5 / sea_radius_m});
}

std::optional<terrain::CloudShade> World::shade_of_clouds(const Camera& camera) const {
  if (!clouds_ || clouds_->shadow() == nullptr) return std::nullopt;
  return terrain::CloudShade{clouds_->shadow_about({camera.eye_m.x, 0.0, camera.eye_m.z}),
                             clouds_->shadow()->map()};
}

}  // namespace offing::world
