#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/cloud_shadow.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// The shadow of clouds: optical depth toward the sun over a square across its light, on the device, read by
/// kernels/clouds/cloud_shadow.clh in shaders and kernels/terrain/terrain_light.clh on the ground.
class CloudShadowMap {
 public:
  using Texel = std::array<float, 4>;

  explicit CloudShadowMap(const ocl::Device& device);

  /// Queues the map of the first `count` particles for light from the unit direction `toward_sun`: a square
  /// of 2 half_width_m a side around `middle_m`, in the particles' axes. Clouds farther than 4 half widths
  /// along the light are left out. Keeps a reference to the particles. Throws Error(bad_usage) if there are
  /// fewer, Error(bad_input) unless the width is above 0 and the direction of unit length within 1e-3.
  void update(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count, const glm::dvec3& toward_sun,
              const glm::dvec3& middle_m, double half_width_m);

  /// For cloud_shadow_depth() and cloud_shadow_share(). map: [CLOUD_SHADOW_SIZE][CLOUD_SHADOW_SIZE], RGBA32F
  /// as a texture.
  const CloudShadowParams& params() const { return params_; }
  const ocl::Buffer<Texel>& map() const { return map_; }

  /// Another one after each update(), unlike that of any other map.
  std::uint64_t revision() const { return revision_; }

  /// Waits for the share of the sun's light that comes straight through to places [n] in the particles' axes:
  /// of exact chords, without the map.
  std::vector<float> transmittance(std::span<const glm::vec3> places_m);

 private:
  ocl::Device device_;
  ocl::KernelTuning splat_tuning_, resolve_tuning_, points_tuning_;
  ocl::Kernel crowd_kernel_, splat_kernel_, resolve_kernel_, points_kernel_;
  const ocl::Buffer<CloudParticle>* particles_ = nullptr;
  std::uint32_t count_ = 0;
  std::uint64_t revision_ = 0;
  CloudShadowParams params_{};
  ocl::Buffer<std::int32_t> moments_;
  ocl::Buffer<Texel> map_;
};

}  // namespace offing::clouds
