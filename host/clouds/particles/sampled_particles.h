#pragma once

#include <cstdint>
#include <vector>

#include "host/base/cloud_volume.h"
#include "host/base/host_memory.h"
#include "host/base/work.h"
#include "host/clouds/shape/cloud_parameters.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// How particles are drawn from a volume.
struct SamplingOptions {
  Sampling sampling = Sampling::uniform;
  int target_particles = 1000;
  std::uint64_t seed = 1;
  std::uint64_t most_bytes = available_host_memory_bytes();  ///< that merging may take
};

/// Particles that stand for a volume (C5), places relative to its origin, at most as many as aimed at, and
/// just as many where the volume has that many cells with density. All of the volume's optical mass is in
/// them, to the rounding of floats.
///
/// uniform: each cell with density is a particle; neighbours are merged, those first that lie close and whose
/// densities are alike, until no more are left than aimed at. What has been merged once is never taken apart:
/// merging what is left, aiming at the same count, changes nothing. Of volumes with more than 40 cells a
/// particle, blocks of cells are averaged first.
/// random: the volume is cut along a curve through all cells (Morton 1966) into parts of equal mass, and from
/// each a place is drawn: quick, but fine features are lost.
///
/// A particle's radius is 1.6 times the one that would spread its mass as far as the cells that it
/// stands for do (equal second moments), so that particles overlap into an even density. The same volume and
/// options give the same particles, however its bricks are stored. Throws what require_valid() of a volume
/// throws, and Error(bad_input) for a target outside 1 ... 10^7, Error(out_of_memory) for one
/// whose cells memory cannot hold, Error(cancelled).
std::vector<CloudParticle> sampled_particles(const CloudVolume& volume, const SamplingOptions& options,
                                             const CloudLook& look, const Work& work = {});

}  // namespace offing::clouds
