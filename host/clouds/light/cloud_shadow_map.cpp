#include "host/clouds/light/cloud_shadow_map.h"

#include <atomic>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"

namespace offing::clouds {
namespace {

constexpr int texels = CLOUD_SHADOW_SIZE * CLOUD_SHADOW_SIZE;
// Work of an item of the simd shape: enough that its launch counts little.
constexpr int simd_particles = 256, strip_texels = 8192, strip_places = 64;

std::size_t items(std::size_t work, int per_item) {
  const auto each = static_cast<std::size_t>(per_item);
  return (work + each - 1) / each;
}

}  // namespace

CloudShadowMap::CloudShadowMap(const ocl::Device& device)
    : device_(device),
      is_simd_(ocl::tuning_for(device.info(), "clouds").shape == ocl::KernelShape::simd),
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
    const int per_item = is_simd_ ? simd_particles : 1;
    for (const ocl::Kernel& kernel : {crowd_kernel_, splat_kernel_}) {
      kernel.launch({{items(count, per_item)}}, particles, static_cast<int>(count), per_item, params_,
                    moments_);
    }
  }
  const int per_item = is_simd_ ? strip_texels : 1;
  resolve_kernel_.launch({{items(texels, per_item)}}, moments_, per_item, map_);
  static std::atomic<std::uint64_t> revisions{0};
  revision_ = ++revisions;
}

std::vector<float> CloudShadowMap::transmittance(std::span<const glm::vec3> places_m) {
  std::vector<float> shares(places_m.size(), 1.0f);
  if (places_m.empty() || count_ == 0) return shares;
  ocl::Buffer<glm::vec3> places(device_, places_m, "places in the shadow of clouds");
  ocl::Buffer<float> found(device_, places_m.size(), "light in the shadow of clouds");
  const int per_item = is_simd_ ? strip_places : 1;
  points_kernel_.launch({{items(places_m.size(), per_item)}}, places, static_cast<int>(places_m.size()),
                        per_item, *particles_, static_cast<int>(count_), params_.sun_x, params_.sun_y,
                        params_.sun_z, found);
  found.read(shares);
  return shares;
}

}  // namespace offing::clouds
