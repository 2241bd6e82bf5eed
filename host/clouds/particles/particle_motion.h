#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "host/clouds/shape/cloud_parameters.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "kernels/shared/cloud_motion.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Where the origin of a cloud's axes is in the world: on its path, else carried from its position by the
/// wind.
glm::dvec3 cloud_origin_m(const CloudParameters& parameters, double time_s);

/// How fast that moves: along its path, m/s to the rounding of its places; else the wind.
glm::dvec3 cloud_velocity_mps(const CloudParameters& parameters, double time_s);

/// How far warm air has lifted a cloud, m: the solution of
///   z'' + 2 c z' + N^2 z = g / T dT exp(-(t - t0) / tau),  z = z' = 0 at t0, 0 before,
/// an excess dT that cools in still air of stability N, its swings damped by c; g / T = 9.81 / 280 m/(s^2 K).
double lift_m(const CloudHeat& heat, double time_s);

/// Moves particles to where they are at a time (C4, C15), by kernels/clouds/particle_motion.cl.
class ParticleMotion {
 public:
  /// Throws what programs throw.
  explicit ParticleMotion(const ocl::Device& device);

  /// Enqueues rest [n], in the cloud's axes, to moved [first ... first + n], relative to origin_m of the
  /// world. densest: the largest optical mass over squared radius among them. cloud: the number that they
  /// get.
  void move(const CloudParameters& parameters, double time_s, const glm::dvec3& origin_m, float densest,
            std::uint32_t cloud, const ocl::Buffer<CloudParticle>& rest, std::uint32_t first,
            const ocl::Buffer<CloudParticle>& moved) const;

 private:
  ocl::Kernel kernel_;
};

}  // namespace offing::clouds
