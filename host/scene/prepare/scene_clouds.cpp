#include "host/scene/prepare/scene_clouds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/clouds/light/scattered_sky.h"
#include "host/clouds/shape/genera.h"
#include "host/scene/model/named_file.h"
#include "host/scene/prepare/cloud_shapes.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {

namespace {

using clouds::CloudParameters;

/// Another seed for each of a scene's; the same where the scene's is its default.
std::uint64_t seed_of(const Scene& scene, std::uint64_t own) {
  constexpr std::uint64_t golden = 0x9e37'79b9'7f4a'7c15;  // odd: spreads small numbers over all bits
  return own ^ ((scene.cloud_settings.seed - 1) * golden);
}

template <typename Target, typename Source>
void take(Target& target, const Source& source) {
  if (source) target = *source;
}

void take_noise(const CloudNoiseScene& noise, clouds::Turbulence& turbulence) {
  take(turbulence.wavelength_m, noise.wavelength_m);
  take(turbulence.lacunarity, noise.lacunarity);
  take(turbulence.gain, noise.gain);
  take(turbulence.strength, noise.strength);
  take(turbulence.blend, noise.blend);
  take(turbulence.wisp, noise.wisp);
  take(turbulence.edge, noise.edge);
  take(turbulence.change_per_s, noise.change_per_s);
  if (noise.octaves > 0) turbulence.octaves = noise.octaves;
}

void take_look(const CloudLookScene& scene, clouds::CloudLook& look) {
  take(look.extinction_per_m, scene.extinction_per_m);
  take(look.albedo, scene.albedo);
  take(look.g, scene.g);
  take(look.g_back, scene.g_back);
  take(look.forward_share, scene.forward_share);
  take(look.droplet_um, scene.droplet_um);
  take(look.phase, scene.phase);
  take(look.billboards, scene.billboards);
}

/// Keyframes of the places of a cloud; of numbers without any a single one.
std::optional<std::array<KeyframeTrack, 3>> path_of(const Scene& scene, std::size_t index,
                                                    const glm::dvec3& position_m) {
  constexpr std::array<const char*, 3> keys{"cloud.x_m", "cloud.y_m", "cloud.z_m"};
  std::array<KeyframeTrack, 3> path;
  bool is_moving = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto track = scene.tracks.find({keys[axis], {index, 0}});
    if (track == scene.tracks.end()) {
      path[axis].keys = {{0.0, position_m[static_cast<int>(axis)]}};
    } else {
      path[axis] = track->second;
      is_moving = true;
    }
  }
  if (!is_moving) return std::nullopt;
  return path;
}

void take_motion(const Scene& scene, std::size_t index, CloudParameters& parameters) {
  const CloudMotionScene& given = scene.clouds[index].motion;
  clouds::CloudMotion& motion = parameters.motion;
  // A cloud of a scene stands still unless told: eyes are placed where it is at the start.
  motion.wind_mps = given.wind_mps.value_or(glm::dvec3(0.0));
  take(motion.shear_per_s, given.shear_per_s);
  take(motion.drag, given.drag_s);
  take(motion.sway_m, given.sway_m);
  motion.path = path_of(scene, index, parameters.position_m);
  if (given.heat_k) {
    motion.heat = given.heat;
    motion.heat->excess_k = *given.heat_k;
    if (motion.heat->damping_per_s > 0.99 * motion.heat->stability_per_s) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected at most 0.99 cloud.heat_stability_per_s, which is {:g}, got {:g}",
                              place_of_name(scene, {"cloud.heat_damping_per_s", {index, 0}}),
                              motion.heat->stability_per_s, motion.heat->damping_per_s),
                  "damp less, or give the air more stability");
    }
  }
  if (given.obstacle_m) motion.obstacle = {*given.obstacle_m, given.obstacle_radius_m};
}

void take_balls(const CloudScene& cloud, CloudParameters& parameters) {
  if (!cloud.balls.empty()) {
    parameters.balls = cloud.balls;
    for (clouds::Metaball& ball : parameters.balls) {
      ball.centre_m *= cloud.scale;
      ball.radius_m *= cloud.scale;
    }
    // Where the preset's base is belongs to its own balls.
    parameters.base_m.reset();
  }
  if (!cloud.levels.empty()) {
    parameters.levels = cloud.levels;
    for (clouds::HierarchyLevel& level : parameters.levels) level.deviation_m *= cloud.scale;
  }
  if (cloud.base_m) parameters.base_m = *cloud.base_m * cloud.scale;
}

void take_edits(const CloudScene& cloud, CloudParameters& parameters) {
  parameters.edits = cloud.edits;
  for (clouds::ParticleEdit& edit : parameters.edits) {
    edit.selection.eye_m *= cloud.scale;
    edit.push_m *= cloud.scale;
  }
}

}  // namespace

CloudParameters cloud_parameters_of(const Scene& scene, std::size_t index) {
  const CloudScene& cloud = scene.clouds[index];
  CloudParameters parameters = clouds::preset(cloud.genus, seed_of(scene, cloud.seed), cloud.scale);
  const double usual_altitude_m = cloud.shape.file.empty() ? parameters.position_m.y : 0.0;
  parameters.position_m = {cloud.position_m.x, cloud.altitude_m.value_or(usual_altitude_m),
                           cloud.position_m.z};
  take(parameters.modelling, cloud.modelling);
  take(parameters.sampling, cloud.sampling);
  if (cloud.target_particles > 0) parameters.target_particles = cloud.target_particles;
  take_balls(cloud, parameters);
  take_noise(cloud.noise, parameters.turbulence);
  take_look(cloud.look, parameters.look);
  take_motion(scene, index, parameters);
  take_edits(cloud, parameters);
  return parameters;
}

namespace {

std::vector<CloudParameters> layer_clouds(const Scene& scene, std::size_t index) {
  const CloudLayerScene& layer = scene.cloud_layers[index];
  try {
    return clouds::scattered_sky({.genus = layer.genus,
                                  .coverage = layer.coverage,
                                  .middle_m = {layer.x_m, layer.z_m},
                                  .extent_m = layer.extent_m,
                                  .base_m = layer.altitude_m},
                                 seed_of(scene, layer.seed));
  } catch (const Error& error) {
    throw Error(
        error.kind(),
        fmt::format("{}: {}", place_of_name(scene, {"cloud_layer.extent_m", {index, 0}}), error.what()),
        "take a smaller cloud_layer.extent_m or cloud_layer.coverage");
  }
}

/// The particles of a hidden cloud, which keeps its place in the list. Always the same object, which tells
/// hidden clouds from others.
const RestingParticles& no_particles() {
  static const RestingParticles none = std::make_shared<const std::vector<CloudParticle>>();
  return none;
}

void take_quality(double quality, CloudParameters& parameters) {
  constexpr double most = 1e7;  // of cloud.target_particles
  parameters.target_particles =
      static_cast<int>(std::clamp(quality * parameters.target_particles, 1.0, most));
  // As many spheres have room on one as its radius over theirs, squared.
  if (parameters.levels.empty()) return;
  double& ratio = parameters.levels.back().ratio;
  ratio = std::clamp(ratio / std::sqrt(quality), 0.02, 1.0);
}

/// What the ranges of single keys let through: their products with cloud.scale, above all.
void require_valid_cloud(const Scene& scene, std::size_t index, const CloudParameters& parameters) {
  try {
    clouds::require_valid(parameters);
  } catch (const Error& error) {
    const bool is_scaled = scene.clouds[index].scale != 1.0;
    const std::string place =
        is_scaled ? place_of_name(scene, {"cloud.scale", {index, 0}}) : fmt::format("cloud {}", index + 1);
    throw Error(error.kind(), fmt::format("{}: {}{}", place, is_scaled ? "scaled, " : "", error.what()),
                is_scaled ? "take another scale, or other lengths" : error.hint());
  }
}

bool is_of_clouds(const std::pair<const ValueKey, KeyframeTrack>& track) {
  return find_parameter(track.first.key)->group == ParameterGroup::cloud;
}

}  // namespace

void copy_clouds(const Scene& from, Scene& to) {
  to.cloud_settings = from.cloud_settings;
  to.clouds = from.clouds;
  to.cloud_layers = from.cloud_layers;
  std::erase_if(to.tracks, is_of_clouds);
  for (const auto& track : from.tracks) {
    if (is_of_clouds(track)) to.tracks.insert(track);
  }
}

bool are_other_clouds(const Scene& before, const Scene& after) {
  return differ_in(Affects::clouds, before, after);
}

std::optional<world::CloudSkyParameters> prepare_clouds(const Scene& scene) {
  CloudShapes shapes;
  return prepare_clouds(scene, shapes);
}

std::optional<world::CloudSkyParameters> prepare_clouds(const Scene& scene, CloudShapes& shapes) {
  if (!scene.has_clouds()) return std::nullopt;
  shapes.begin();
  world::CloudSkyParameters sky{.clouds = {},
                                .particles = {},
                                .light_model = scene.cloud_settings.light,
                                .throws_shadows = scene.cloud_settings.shadows == CloudShadows::on,
                                .light_step_s = scene.cloud_settings.light_step_s};
  for (std::size_t i = 0; i < scene.clouds.size(); ++i) {
    CloudParameters parameters = cloud_parameters_of(scene, i);
    take_quality(scene.cloud_settings.quality, parameters);
    require_valid_cloud(scene, i, parameters);
    if (scene.clouds[i].visible == CloudVisibility::on) {
      sky.particles.push_back(shapes.take(scene, i, parameters));
    } else {
      shapes.keep(scene, i, parameters);
      sky.particles.push_back(no_particles());
    }
    sky.clouds.push_back(std::move(parameters));
  }
  for (std::size_t i = 0; i < scene.cloud_layers.size(); ++i) {
    if (scene.cloud_layers[i].visible == CloudVisibility::off) continue;
    for (CloudParameters& parameters : layer_clouds(scene, i)) {
      take_quality(scene.cloud_settings.quality, parameters);
      sky.clouds.push_back(std::move(parameters));
    }
  }
  const std::ptrdiff_t hidden = std::ranges::count(sky.particles, no_particles());
  // No cloud is left: all are hidden, or layers cover nothing.
  if (hidden == std::ssize(sky.clouds)) return std::nullopt;
  return sky;
}

void edit_clouds(world::World& world, const Scene& before, const Scene& after) {
  if (are_other_clouds(before, after)) world.set_clouds(prepare_clouds(after));
}

}  // namespace offing::scene
