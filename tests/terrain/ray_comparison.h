#pragma once

#include <cstddef>
#include <vector>

#include "tests/terrain/example_maps.h"
#include "tests/terrain/reference_walk.h"

namespace offing::test {

/// Whether a ray's answer stays when all heights move by 1e-4 cells: others touch the surface, and rounding
/// decides.
bool is_robust(const HeightMap& map, const terrain::Ray& ray, const ReferenceHit& hit);

/// How hits differ from those of reference_walk.h.
struct RayComparison {
  std::size_t wrong = 0;     ///< robust rays whose kind differs, or whose distance by more than 1e-3 cells
  std::size_t touching = 0;  ///< other rays of which that is so
  std::size_t hits = 0;
  double worst_cells = 0.0;  ///< |t - t_reference| |n.d| of the others
};

std::vector<ReferenceHit> reference_hits(const HeightMap& map, const std::vector<terrain::Ray>& rays);

/// Adds a failure for each of the first few wrong rays.
RayComparison compare(const HeightMap& map, const std::vector<terrain::Ray>& rays,
                      const std::vector<ReferenceHit>& references, const std::vector<terrain::RayHit>& found);
/// The same against reference_hits(map, rays).
RayComparison compare(const HeightMap& map, const std::vector<terrain::Ray>& rays,
                      const std::vector<terrain::RayHit>& found);

}  // namespace offing::test
