#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/cloud_volume.h"
#include "host/base/work.h"

namespace offing::clouds {

/// A cell, or a block of cells, with density.
struct VolumeSample {
  std::array<int, 3> block;  ///< which one, from the volume's corner
  glm::dvec3 place_m{0.0};   ///< middle of its mass, relative to the volume's origin
  double mass = 0.0;         ///< its density times its volume, m^3
  double square_m2 = 0.0;    ///< mean squared distance of its mass from place_m
  glm::vec3 albedo{1.0f};    ///< mean of its mass, where the volume tells albedos
};

/// What two samples are together; the block of the first.
VolumeSample merged(const VolumeSample& a, const VolumeSample& b);

/// Blocks of a volume, ordered by z, y, x, with their edges.
struct VolumeBlocks {
  std::vector<VolumeSample> samples;
  double edge_m = 0.0;
};

/// The cells of a volume with density, in the smallest blocks that are no more than `most`, one or more.
/// Takes no more memory than `most` blocks do. Throws Error(cancelled).
VolumeBlocks volume_samples(const CloudVolume& volume, std::size_t most, const Work& work = {});

/// Merges neighbours until no more than `most` are left (C5). Neighbours are blocks that share a face, and
/// what neighbours merged into. Of all pairs the next to merge is the one that adds least to the sum of v |a
/// - b|^2 (s + (difference of densities / the largest)^2), v the volumes' product over their sum: Ward's
/// criterion (Ward 1963), weighed by how alike they are; s makes all the same interiors fall into parts of
/// about one size. Each part is more or less willing by chance, or those of even density would be merged in
/// rows and lie on a lattice. Where nothing touches any more, the rest stays apart.
///
/// samples: ordered as volume_samples() has them; what is left has that order too. Takes about
/// merging_bytes for each. Throws Error(cancelled).
std::vector<VolumeSample> merged_samples(const VolumeBlocks& samples, std::size_t most, std::uint64_t seed,
                                         const Work& work = {});

inline constexpr double merging_bytes = 400.0;

}  // namespace offing::clouds
