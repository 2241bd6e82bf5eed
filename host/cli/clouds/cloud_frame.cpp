#include "host/cli/clouds/cloud_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "host/clouds/light/field_albedo.h"
#include "host/clouds/shape/cloud_density.h"
#include "host/world/cloud_grower.h"

namespace offing::cli {

namespace {

using clouds::CloudParameters;

bool is_grey(const glm::dvec3& albedo) {
  return albedo.x == albedo.y && albedo.y == albedo.z;
}

/// Whether nothing but drift moves a cloud, so that its field is what its particles stand for.
bool keeps_its_form(const clouds::CloudMotion& motion) {
  const bool has_wind = motion.wind_mps != glm::dvec3(0.0);
  const bool leans = has_wind && (motion.shear_per_s != 0.0 || motion.drag != 0.0);
  return !leans && motion.sway_m == 0.0 && !motion.heat && !motion.obstacle;
}

}  // namespace

CloudFrames::CloudFrames(const ocl::Device& device, world::CloudSkyParameters sky, const CancelToken& cancel)
    : device_(device), cancel_(cancel), sky_(std::move(sky)) {}

world::WorldClouds& CloudFrames::view() {
  if (!view_) view_.emplace(device_, world::CloudGrower(device_).grown(sky_, cancel_));
  return *view_;
}

ParticleCloud CloudFrames::particles_at(double time_s) {
  view().at(time_s);
  ParticleCloud cloud{.origin_m = view().sky_origin_m(), .particles = view().particles().read()};
  cloud.particles.resize(view().count());
  return cloud;
}

VdbCloud CloudFrames::volume_at(double time_s, double cell_m) {
  const bool has_given_particles = !sky_.particles.empty() && sky_.particles.front();
  const CloudParameters& first = sky_.clouds.front();
  const bool is_field = first.modelling == clouds::Modelling::sampled || first.shape;
  if (sky_.clouds.size() > 1 || !is_field || has_given_particles || !first.edits.empty() ||
      !keeps_its_form(first.motion)) {
    return rasterised_at(time_s, cell_m);
  }
  CloudParameters at_rest = first;
  at_rest.turbulence.change_per_s = 0.0;  // its particles have the noise of time 0 too
  VdbCloud cloud{.volume = clouds::density_volume(device_, at_rest, cell_m, time_s)};
  cloud.albedo = std::exchange(cloud.volume.albedo, {});
  if (!cloud.albedo.empty()) return cloud;
  const glm::dvec3& albedo = first.look.albedo;
  if (!is_grey(albedo)) {
    cloud.albedo.assign(
        cloud.volume.density.size(),
        {static_cast<float>(albedo.x), static_cast<float>(albedo.y), static_cast<float>(albedo.z)});
  }
  return cloud;
}

VdbCloud CloudFrames::rasterised_at(double time_s, double cell_m) {
  const ParticleCloud cloud = particles_at(time_s);
  const double extinction_per_m = sky_.clouds.front().look.extinction_per_m;
  VdbCloud result{.volume = clouds::rasterised(device_, cloud.particles, cell_m, extinction_per_m)};
  result.albedo = clouds::rasterised_albedo(device_, cloud.particles, result.volume);
  result.volume.origin_m += cloud.origin_m;
  return result;
}

double usual_cell_m(const ParticleCloud& cloud) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const CloudParticle& particle : cloud.particles) {
    const glm::dvec3 place_m(particle.x, particle.y, particle.z);
    low = glm::min(low, place_m - glm::dvec3(particle.radius));
    high = glm::max(high, place_m + glm::dvec3(particle.radius));
  }
  constexpr double cells = 128.0;
  const glm::dvec3 size_m = high - low;
  const double edge_m = std::max({size_m.x, size_m.y, size_m.z, 1e-3}) / cells;
  const double magnitude = std::pow(10.0, std::floor(std::log10(edge_m)));
  const double round_m = std::round(edge_m / magnitude * 2.0) / 2.0 * magnitude;  // 1, 1.5, 2 ... 9.5, 10
  return std::clamp(round_m, least_cell_m, largest_cell_m);
}

}  // namespace offing::cli
