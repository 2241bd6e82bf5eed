#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/clouds/particles/volume_samples.h"

namespace offing::clouds {

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
