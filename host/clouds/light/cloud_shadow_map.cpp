#include "host/clouds/light/cloud_shadow_map.h"

#include <atomic>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/ocl/program.h"

namespace offing::clouds {
namespace {

constexpr int texels = CLOUD_SHADOW_SIZE * CLOUD_SHADOW_SIZE;

}  // namespace

CloudShadowMap::CloudShadowMap(const ocl::Device& device)
    : device_(device),
      splat_tuning_(ocl::tuning_for(device.info(), "shadow_splat")),
      resolve_tuning_(ocl::tuning_for(device.info(), "shadow_resolve")),
      points_tuning_(ocl::tuning_for(device.info(), "shadow_points")),
      crowd_kernel_(ocl::Program::build(device, "clouds/shadow_crowd.cl").kernel("shadow_crowd")),
      splat_kernel_(ocl::Program::build(device, "clouds/shadow_splat.cl").kernel("shadow_splat")),
      resolve_kernel_(ocl::Program::build(device, "clouds/shadow_resolve.cl").kernel("shadow_resolve")),
      points_kernel_(ocl::Program::build(device, "clouds/shadow_points.cl").kernel("shadow_points")),
      moments_(device, 4 * std::size_t{texels}, "moments of the clouds' shadow"),
      map_(device, std::size_t{texels}, "shadow map of clouds") {
  map_.fill({});
}

void CloudShadowMap::update(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
                            const glm::dvec3& toward_sun, const glm::dvec3& middle_m, double half_width_m) {
  if (count > particles.size()) {
    throw Error(ErrorKind::bad_usage, fmt::format("shadow of clouds: expected at most {} particles, got {}",
                                                  particles.size(), count));
  }
  if (!(half_width_m > 0.0 && std::isfinite(half_width_m)) ||
      !(std::abs(glm::length(toward_sun) - 1.0) < 1e-3)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format(
            "shadow of clouds: expected a half width above 0 and a unit vector, got {} and ({}, {}, {})",
            half_width_m, toward_sun.x, toward_sun.y, toward_sun.z));
  }
  particles_ = &particles;
  count_ = count;
  const glm::dvec3 aside =
      std::abs(toward_sun.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::vec3 right(glm::normalize(glm::cross(aside, toward_sun))), sun(toward_sun), middle(middle_m);
  const glm::vec3 up = glm::cross(sun, right);
  params_ = {middle.x,
             middle.y,
             middle.z,
             right.x,
             right.y,
             right.z,
             up.x,
             up.y,
             up.z,
             sun.x,
             sun.y,
             sun.z,
             static_cast<float>(half_width_m),
             0.0f,
             0.0f,
             0.0f};
  moments_.fill(0);
  if (count > 0) {
    for (const ocl::Kernel& kernel : {crowd_kernel_, splat_kernel_}) {
      kernel.launch(ocl::launch_shape(splat_tuning_, count), particles, static_cast<int>(count),
                    splat_tuning_.per_item, params_, moments_);
    }
  }
  resolve_kernel_.launch(ocl::launch_shape(resolve_tuning_, texels), moments_, resolve_tuning_.per_item,
                         map_);
  static std::atomic<std::uint64_t> revisions{0};
  revision_ = ++revisions;
}

std::vector<float> CloudShadowMap::transmittance(std::span<const glm::vec3> places_m) {
  std::vector<float> shares(places_m.size(), 1.0f);
  if (places_m.empty() || count_ == 0) return shares;
  ocl::Buffer<glm::vec3> places(device_, places_m, "places in the shadow of clouds");
  ocl::Buffer<float> found(device_, places_m.size(), "light in the shadow of clouds");
  points_kernel_.launch(ocl::launch_shape(points_tuning_, places_m.size()), places,
                        static_cast<int>(places_m.size()), points_tuning_.per_item, *particles_,
                        static_cast<int>(count_), params_.sun_x, params_.sun_y, params_.sun_z, found);
  found.read(shares);
  return shares;
}

}  // namespace offing::clouds
