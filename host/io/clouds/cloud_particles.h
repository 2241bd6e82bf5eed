#pragma once

#include <filesystem>
#include <vector>

#include <glm/vec3.hpp>

#include "host/io/atomic_file.h"
#include "kernels/shared/clouds.h"

namespace offing {

/// Particles of a cloud or of a sky.
struct ParticleCloud {
  glm::dvec3 origin_m{0.0};  ///< in the world: what their places are relative to
  std::vector<CloudParticle> particles;
};

/// Writes particles as a binary PLY of vertices, atomically and with the same bytes for the same particles: x
/// y z (double, in the world), radius, optical_mass, red green blue, turn (float), texture cloud id (uint),
/// as CloudParticle has them. Throws Error(file) if it cannot be written.
void write_cloud_particles(const std::filesystem::path& path, const ParticleCloud& cloud,
                           Existing existing = Existing::replace);

/// Reads particles of a PLY, text or binary: x y z radius optical_mass must be there; without the others
/// albedo is 1, texture, cloud and turn are 0 and ids count from 0. Places become relative to a multiple of
/// 1024 m in the middle of them, so that a cloud of 16 km keeps them to 1e-3 m.
///
/// Throws Error(bad_input) that names the file and the place in it for what is no PLY, ends early, or has
/// values that are not finite or break what CloudParticle promises, for none at all and for more than
/// most_cloud_particles; Error(file) where it must not be read.
ParticleCloud read_cloud_particles(const std::filesystem::path& path);

/// 2^27 particles are 6 GiB.
inline constexpr std::size_t most_cloud_particles = std::size_t{1} << 27;

}  // namespace offing
