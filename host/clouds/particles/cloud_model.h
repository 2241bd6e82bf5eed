#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/work.h"
#include "host/clouds/light/light_of_others.h"
#include "host/clouds/particles/particle_motion.h"
#include "host/clouds/shape/cloud_parameters.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"

namespace offing::clouds {

/// The particles of a cloud at rest, in its axes, ids counting from 0: sampled from the density of its balls
/// or its shape (C5), or grown on its balls as seeds (C7). Throws what require_valid(), field_volume(),
/// sampled_particles() and grown_hierarchy() throw, and Error(out_of_memory) where
/// target_particles are more than an array of the device can hold. They depend neither on where the cloud is
/// nor on how it moves, and have none of its edits.
/// Throws Error(cancelled) soon after it is asked to stop.
std::vector<CloudParticle> particles_at_rest(const ocl::Device& device, const CloudParameters& parameters,
                                             const Work& work = {});

/// Throws Error(bad_input) with the time needed if sampling this cloud would take longer than a first picture
/// may (host/base/time_estimate.h). Of many particles some are sampled to know, which costs a second or two.
void require_short_sampling(const ocl::Device& device, const CloudParameters& parameters);

/// A cloud of particles that moves. The same parameters give the same particles with the same ids; any time
/// is reached at once, whatever time was asked for before.
class CloudModel {
 public:
  /// Throws what particles_at_rest() throws. cloud: the number that its particles get.
  CloudModel(const ocl::Device& device, const CloudParameters& parameters, std::uint32_t cloud = 0);
  /// With particles in place of those that the parameters give: at rest, in the cloud's axes, before its
  /// edits.
  CloudModel(const ocl::Device& device, const CloudParameters& parameters,
             std::span<const CloudParticle> at_rest, std::uint32_t cloud = 0);

  /// The same cloud of fewer particles: thinned_particles() of them at rest, after its edits. Waits for the
  /// device. Throws as that does.
  CloudModel thinned(const ocl::Device& device, int halvings) const;

  /// Enqueues the particles at a time, relative to the cloud's position_m.
  void at(double time_s) { at(time_s, parameters_.position_m); }
  /// Relative to a place of the world: near the eye or the sky's clouds, so that floats keep their digits.
  void at(double time_s, const glm::dvec3& origin_m);
  /// Into an array of several clouds: places first ... first + count().
  void at(double time_s, const glm::dvec3& origin_m, const ocl::Buffer<CloudParticle>& target,
          std::uint32_t first) const;

  /// Of the last at(), [count()], or a single one without meaning where count() is 0.
  const ocl::Buffer<CloudParticle>& particles() const { return moved_; }
  std::uint32_t count() const { return count_; }
  /// Whether a particle has another albedo than the look.
  bool has_own_albedo() const { return has_own_albedo_; }
  /// At rest.
  const CloudExtent& extent() const { return extent_; }
  const CloudParameters& parameters() const { return parameters_; }

 private:
  /// With particles as they are after the edits of the parameters.
  CloudModel(const ocl::Device& device, std::span<const CloudParticle> edited,
             const CloudParameters& parameters, std::uint32_t cloud);

  CloudParameters parameters_;
  std::uint32_t count_, cloud_;
  CloudExtent extent_;
  float densest_ = 1.0f;
  bool has_own_albedo_ = false;
  ParticleMotion motion_;
  ocl::Buffer<CloudParticle> rest_, moved_;
};

}  // namespace offing::clouds
