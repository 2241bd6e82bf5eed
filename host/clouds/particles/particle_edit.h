#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Particles at rest whose middles an eye sees within a rectangle of its picture, however far away: what a
/// box on a screen selects, told by space alone, so that it selects again when the cloud is made anew.
struct ParticleSelection {
  glm::dvec3 eye_m{0.0};  ///< in the cloud's axes
  double yaw_rad = 0.0;   ///< as a Camera has it (host/base/camera.h), without roll
  double pitch_rad = 0.0;
  glm::dvec2 low{-1.0}, high{1.0};  ///< of the rectangle: right and up, at distance 1 along the line of sight

  bool operator==(const ParticleSelection&) const = default;
};

enum class ParticleFate { kept, removed };

/// An edit by hand of the particles of a cloud: a layer over how they are made (C13).
struct ParticleEdit {
  ParticleSelection selection;
  ParticleFate fate = ParticleFate::kept;
  glm::dvec3 push_m{0.0};
  std::optional<glm::dvec3> albedo = {};  ///< in place of their own

  bool operator==(const ParticleEdit&) const = default;
};

/// Those of some particles that it selects, in their order.
std::vector<CloudParticle> selected_particles(std::span<const CloudParticle> particles,
                                              const ParticleSelection& selection);

/// What edits make of particles at rest, one after another: each selects where those before it have pushed
/// them. The others stay as they are, in their order, with their ids.
std::vector<CloudParticle> edited_particles(std::span<const CloudParticle> at_rest,
                                            std::span<const ParticleEdit> edits);

}  // namespace offing::clouds
