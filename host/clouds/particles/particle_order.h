#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "host/clouds/particles/radix_sort.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Sorts particles by how far they are from an eye or from a light, on the device. Particles at the same
/// distance keep their order; one whose place is not a number counts as farthest.
class ParticleOrder {
 public:
  explicit ParticleOrder(const ocl::Device& device);

  /// Queues the order of the first `count` particles as seen from the eye (same axes as theirs): far to near,
  /// as they are blended. Throws Error(bad_usage) if there are fewer.
  const ocl::Buffer<std::uint32_t>& far_to_near(const ocl::Buffer<CloudParticle>& particles,
                                                std::uint32_t count, const glm::vec3& eye_m);
  /// The same away from a light in the unit direction `toward_light`: near to far.
  const ocl::Buffer<std::uint32_t>& along_light(const ocl::Buffer<CloudParticle>& particles,
                                                std::uint32_t count, const glm::vec3& toward_light);

  /// [count at least] places in the array of particles, of the last order.
  const ocl::Buffer<std::uint32_t>& order() const { return sort_.values(); }

 private:
  enum class From { place, direction };
  void sort(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count, const glm::vec3& source,
            From from, std::uint32_t flip);

  ocl::KernelTuning tuning_;
  ocl::Kernel key_kernel_;
  RadixSort sort_;
};

/// The order in which an eye blends particles.
class ViewOrder {
 public:
  explicit ViewOrder(const ocl::Device& device) : order_(device) {}

  /// See ParticleOrder::far_to_near().
  const ocl::Buffer<std::uint32_t>& sort(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
                                         const glm::vec3& eye_m) {
    return order_.far_to_near(particles, count, eye_m);
  }
  const ocl::Buffer<std::uint32_t>& order() const { return order_.order(); }

 private:
  ParticleOrder order_;
};

}  // namespace offing::clouds
