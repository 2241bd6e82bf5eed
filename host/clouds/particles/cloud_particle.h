#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "host/clouds/shape/cloud_parameters.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Throws Error(bad_input) that names the particle by its number and its first value out of range.
void require_valid(const CloudParticle& particle, std::size_t number);

/// Which particle of which seed: what its texture and its turn are drawn from.
struct ParticleKey {
  std::uint64_t seed = 1;
  std::uint32_t id = 0;
};

/// A particle of cloud 0 with a texture of its look's set and a turn drawn at random, the same for the same
/// key.
CloudParticle cloud_particle(const glm::dvec3& place_m, double radius_m, double optical_mass_m2,
                             const CloudLook& look, const ParticleKey& key);

}  // namespace offing::clouds
