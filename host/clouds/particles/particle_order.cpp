#include "host/clouds/particles/particle_order.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"

namespace offing::clouds {

ParticleOrder::ParticleOrder(const ocl::Device& device)
    : tuning_(ocl::tuning_for(device.info(), "order_key")),
      key_kernel_(ocl::Program::build(device, "clouds/order_key.cl").kernel("order_key")),
      sort_(device) {}

void ParticleOrder::sort(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
                         const glm::vec3& source, From from, std::uint32_t flip) {
  if (count > particles.size()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("order: expected at most {} particles, got {}", particles.size(), count));
  }
  if (count == 0) return;
  sort_.reserve(count);
  key_kernel_.launch(ocl::launch_shape(tuning_, count), particles, static_cast<int>(count), tuning_.per_item,
                     source.x, source.y, source.z, from == From::place ? 1 : 0, flip, sort_.keys(),
                     sort_.values());
  sort_.sort(count);
}

const ocl::Buffer<std::uint32_t>& ParticleOrder::far_to_near(const ocl::Buffer<CloudParticle>& particles,
                                                             std::uint32_t count, const glm::vec3& eye_m) {
  sort(particles, count, eye_m, From::place, ~0u);
  return order();
}

const ocl::Buffer<std::uint32_t>& ParticleOrder::along_light(const ocl::Buffer<CloudParticle>& particles,
                                                             std::uint32_t count,
                                                             const glm::vec3& toward_light) {
  sort(particles, count, toward_light, From::direction, 0u);
  return order();
}

}  // namespace offing::clouds
