#include "host/clouds/particles/particle_motion.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "host/ocl/program.h"

namespace offing::clouds {
namespace {

// Gravity over the air's temperature, m/(s^2 K): at 280 K.
constexpr double gravity_per_k = 9.81 / 280.0;

void set(const glm::dvec3& value, float& x, float& y, float& z) {
  x = static_cast<float>(value.x);
  y = static_cast<float>(value.y);
  z = static_cast<float>(value.z);
}

CloudMotionParams motion_params(const CloudParameters& parameters, double time_s,
                                const glm::dvec3& origin_m) {
  const CloudMotion& motion = parameters.motion;
  CloudMotionParams params{};
  set(cloud_origin_m(parameters, time_s) - origin_m, params.drift_x, params.drift_y, params.drift_z);
  const double wind_mps = glm::length(motion.wind_mps);
  if (wind_mps > 0.0) set(motion.wind_mps / wind_mps, params.along_x, params.along_y, params.along_z);
  params.lean = static_cast<float>(motion.shear_per_s * motion.shear_lasts_s *
                                   std::tanh(time_s / motion.shear_lasts_s));
  params.run = static_cast<float>(motion.drag * wind_mps);
  params.sway = static_cast<float>(motion.sway_m);
  params.sway_per_m = static_cast<float>(1.0 / parameters.turbulence.wavelength_m);
  const double layer = time_s * parameters.turbulence.change_per_s, whole = std::floor(layer);
  params.sway_layer = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole) & 0xffffff);
  params.sway_fraction = static_cast<float>(layer - whole);
  params.seed_low = static_cast<std::uint32_t>(parameters.seed);
  params.seed_high = static_cast<std::uint32_t>(parameters.seed >> 32);
  if (motion.heat) {
    params.lift = static_cast<float>(lift_m(*motion.heat, time_s));
    params.spread = static_cast<float>(motion.heat->spread);
    params.condensation = static_cast<float>(motion.heat->condensation_m);
    params.condensing = static_cast<float>(motion.heat->condensing_m);
  }
  const glm::dvec3 velocity_mps = cloud_velocity_mps(parameters, time_s);
  // What stands still is where it was put, and flows around nothing.
  if (const double speed_mps = glm::length(velocity_mps); motion.obstacle && speed_mps > 0.0) {
    set(velocity_mps / speed_mps, params.flow_x, params.flow_y, params.flow_z);
    set(motion.obstacle->centre_m - origin_m, params.sphere_x, params.sphere_y, params.sphere_z);
    params.sphere_radius = static_cast<float>(motion.obstacle->radius_m);
  }
  return params;
}

}  // namespace

glm::dvec3 cloud_origin_m(const CloudParameters& parameters, double time_s) {
  if (!parameters.motion.path) return parameters.position_m + parameters.motion.wind_mps * time_s;
  const auto& path = *parameters.motion.path;
  return {value_at(path[0], time_s), value_at(path[1], time_s), value_at(path[2], time_s)};
}

glm::dvec3 cloud_velocity_mps(const CloudParameters& parameters, double time_s) {
  if (!parameters.motion.path) return parameters.motion.wind_mps;
  constexpr double half_s = 0.05;  // within the time of a frame or two
  return (cloud_origin_m(parameters, time_s + half_s) - cloud_origin_m(parameters, time_s - half_s)) /
         (2.0 * half_s);
}

double lift_m(const CloudHeat& heat, double time_s) {
  const double t = time_s - heat.begins_s;
  if (t <= 0.0) return 0.0;
  const double n = heat.stability_per_s, c = heat.damping_per_s, cooling = 1.0 / heat.cooling_s;
  const double swing = std::sqrt(n * n - c * c);
  const double forced = gravity_per_k * heat.excess_k / (cooling * cooling - 2.0 * c * cooling + n * n);
  return forced * (std::exp(-cooling * t) -
                   std::exp(-c * t) * (std::cos(swing * t) + (c - cooling) / swing * std::sin(swing * t)));
}

ParticleMotion::ParticleMotion(const ocl::Device& device)
    : kernel_(ocl::Program::build(device, "clouds/particle_motion.cl").kernel("particle_motion")) {}

void ParticleMotion::move(const CloudParameters& parameters, double time_s, const glm::dvec3& origin_m,
                          float densest, std::uint32_t cloud, const ocl::Buffer<CloudParticle>& rest,
                          std::uint32_t first, const ocl::Buffer<CloudParticle>& moved) const {
  CloudMotionParams params = motion_params(parameters, time_s, origin_m);
  params.densest = densest;
  params.cloud = cloud;
  kernel_.launch({{rest.size()}}, rest, params, first, moved);
}

}  // namespace offing::clouds
