#pragma once

#include <cstddef>
#include <vector>

#include "host/base/camera.h"
#include "kernels/shared/terrain.h"
#include "tests/terrain/example_maps.h"

namespace offing::test {

/// How the hits of a picture of a dense wood differ from a march in double precision through the same crowns
/// (kernels/terrain/canopy): smooth ones, and near the eye those that the most leaves take away.
struct CrownComparison {
  std::size_t rays = 0, crowns = 0;  ///< rays that were compared, and those that hit a crown or a trunk
  std::size_t smooth = 0;            ///< hits of crowns too far away for leaves
  std::size_t wrong = 0;             ///< off by more than 1e-3 of the map's cell, a hole, or a hit of nothing
  std::size_t touching = 0;          ///< the same of rays that are less than that in a crown before
  double worst_cells = 0.0;          ///< across the surface of smooth crowns, of all others
};

/// Of rays as far as `farthest_m` through a wood that is dense everywhere and whose highest crowns are so
/// high. Adds a failure for each of the first few wrong rays.
CrownComparison compare_crowns(const HeightMap& map, double highest_m, const Camera& camera,
                               double farthest_m, const std::vector<TerrainHit>& hits);

}  // namespace offing::test
