#include "host/clouds/shape/cloud_parameters.h"

#include <string_view>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/clouds/light/phase_function.h"
#include "kernels/shared/cloud_field.h"

namespace offing::clouds {
namespace {

// Widest cloud, m, and how many balls and levels anybody can mean.
constexpr double largest_cloud_m = 1e6;
constexpr std::size_t most_balls = 1'000'000;
constexpr std::size_t most_levels = 6;

void require_place(const std::string& name, const glm::dvec3& place_m, double farthest_m) {
  require_within(name + ".x", place_m.x, -farthest_m, farthest_m);
  require_within(name + ".y", place_m.y, -farthest_m, farthest_m);
  require_within(name + ".z", place_m.z, -farthest_m, farthest_m);
}

void require_valid(const Turbulence& turbulence) {
  require_within("cloud.turbulence.wavelength_m", turbulence.wavelength_m, 1e-2, 1e6);
  require_within("cloud.turbulence.octaves", turbulence.octaves, 0, CLOUD_OCTAVES_MOST);
  require_within("cloud.turbulence.lacunarity", turbulence.lacunarity, 1.1, 8.0);
  require_within("cloud.turbulence.gain", turbulence.gain, 0.0, 1.0);
  require_within("cloud.turbulence.strength", turbulence.strength, 0.0, 100.0);
  require_within("cloud.turbulence.blend", turbulence.blend, 0.0, 1.0);
  require_within("cloud.turbulence.wisp", turbulence.wisp, 0.1, 10.0);
  require_within("cloud.turbulence.edge", turbulence.edge, 1e-6, 100.0);
  require_within("cloud.turbulence.change_per_s", turbulence.change_per_s, 0.0, 100.0);
}

void require_valid(const CloudLook& look) {
  require_within("cloud.extinction_per_m", look.extinction_per_m, 1e-9, 100.0);
  require_within("cloud.albedo.red", look.albedo.x, 0.0, 1.0);
  require_within("cloud.albedo.green", look.albedo.y, 0.0, 1.0);
  require_within("cloud.albedo.blue", look.albedo.z, 0.0, 1.0);
  require_within("cloud.g", look.g, least_mean_cosine, 0.99);
  require_within("cloud.g_back", look.g_back, -0.99, 0.99);
  require_within("cloud.forward_share", look.forward_share, 0.0, 1.0);
  require_within("cloud.droplet_um", look.droplet_um, smallest_droplet_um, largest_droplet_um);
  require_within("cloud: mean cosine of scattering, of g, g_back and forward_share",
                 PhaseFunction(look).mean_cosine(), least_mean_cosine, 1.0);
}

void require_valid(const CloudMotion& motion) {
  require_place("cloud.wind_mps", motion.wind_mps, 300.0);
  require_within("cloud.shear_per_s", motion.shear_per_s, -1.0, 1.0);
  require_within("cloud.shear_lasts_s", motion.shear_lasts_s, 1.0, largest_time_s);
  require_within("cloud.drag", motion.drag, 0.0, 1e4);
  require_within("cloud.sway_m", motion.sway_m, 0.0, 1e5);
  if (motion.path) {
    for (const KeyframeTrack& track : *motion.path) {
      for (const Keyframe& key : track.keys) {
        require_within("cloud.path", key.value, -farthest_point_m, farthest_point_m);
      }
    }
  }
  if (motion.heat) {
    require_within("cloud.heat.begins_s", motion.heat->begins_s, -largest_time_s, largest_time_s);
    require_within("cloud.heat.excess_k", motion.heat->excess_k, 0.0, 50.0);
    require_within("cloud.heat.spread", motion.heat->spread, 0.0, 1.0);
    require_within("cloud.heat.cooling_s", motion.heat->cooling_s, 1.0, largest_time_s);
    require_within("cloud.heat.stability_per_s", motion.heat->stability_per_s, 1e-4, 1.0);
    // Overdamped air would not swing: another solution, which no air needs.
    require_within("cloud.heat.damping_per_s", motion.heat->damping_per_s, 0.0,
                   0.99 * motion.heat->stability_per_s);
    require_within("cloud.heat.condensation_m", motion.heat->condensation_m, -largest_cloud_m,
                   largest_cloud_m);
    require_within("cloud.heat.condensing_m", motion.heat->condensing_m, 1e-3, largest_cloud_m);
  }
  if (motion.obstacle) {
    require_place("cloud.obstacle", motion.obstacle->centre_m, farthest_point_m);
    require_within("cloud.obstacle.radius_m", motion.obstacle->radius_m, 1e-3, largest_cloud_m);
  }
}

}  // namespace

void require_valid(const CloudParameters& parameters) {
  require_place("cloud.position_m", parameters.position_m, farthest_point_m);
  require_within("cloud balls", static_cast<double>(parameters.balls.size()), 0.0,
                 static_cast<double>(most_balls));
  for (std::size_t i = 0; i < parameters.balls.size(); ++i) {
    const Metaball& ball = parameters.balls[i];
    const std::string name = fmt::format("cloud.ball[{}]", i);
    require_place(name, ball.centre_m, largest_cloud_m);
    require_within(name + ".radius_m", ball.radius_m, 1e-3, largest_cloud_m);
    require_within(name + ".weight", ball.weight, 0.0, 1e4);
  }
  if (parameters.shape) require_valid(*parameters.shape);
  require_valid(parameters.turbulence);
  require_within("cloud.target_particles", parameters.target_particles, 1, 10'000'000);
  require_within("cloud levels", static_cast<double>(parameters.levels.size()), 0, most_levels);
  for (std::size_t i = 0; i < parameters.levels.size(); ++i) {
    const HierarchyLevel& level = parameters.levels[i];
    const std::string name = fmt::format("cloud.level[{}]", i);
    require_within(name + ".ratio", level.ratio, 0.02, 1.0);
    require_within(name + ".deviation_m", level.deviation_m, 0.0, largest_cloud_m);
    require_within(name + ".repulsion", level.repulsion, 0.05, 20.0);
  }
  if (parameters.base_m) {
    require_within("cloud.base_m", *parameters.base_m, -largest_cloud_m, largest_cloud_m);
  }
  for (std::size_t i = 0; i < parameters.edits.size(); ++i) {
    const ParticleEdit& edit = parameters.edits[i];
    const std::string name = fmt::format("cloud.particle_edit[{}]", i);
    require_place(name + ".eye_m", edit.selection.eye_m, farthest_point_m);
    require_place(name + ".push_m", edit.push_m, largest_cloud_m);
  }
  require_valid(parameters.look);
  require_valid(parameters.motion);
}

}  // namespace offing::clouds
