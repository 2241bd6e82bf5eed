#pragma once

#include "tests/terrain/example_maps.h"

namespace offing::test {

/// What a ray hits first, in double precision.
struct ReferenceHit {
  double distance_m = 0.0;  ///< +inf is a miss
  int kind = TERRAIN_MISS;
  double facing = 1.0;  ///< |n.d|
};

/// Visits every patch that the ray passes, in order, and solves each without a pyramid or a start level. All
/// heights are `raised_m` higher than the map has them.
ReferenceHit reference_hit(const HeightMap& map, const terrain::Ray& ray, double raised_m = 0.0);

}  // namespace offing::test
