#pragma once

#include <array>
#include <cstddef>
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

}  // namespace offing::clouds
