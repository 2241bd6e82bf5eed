#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/terrain/cast/relief_surface.h"
#include "tests/terrain/example_maps.h"

namespace offing::test {

/// Posts of the drawn ground, bilinear between them.
struct PostSheet {
  double left_m = 0.0, top_m = 0.0, step_x_m = 1.0, step_z_m = 1.0;  ///< of its first post and its cells
  int cells_x = 0, cells_z = 0;
  std::size_t columns = 0;
  std::vector<float> heights_m = {};

  float post_m(int x, int z) const {
    return heights_m[static_cast<std::size_t>(z) * columns + static_cast<std::size_t>(x)];
  }
};

/// The levels of a relief as the device has them, the finest first, and the map.
std::vector<PostSheet> sheets_of(const HeightMap& map, const terrain::ReliefSurface& relief);

/// How a picture's hits differ from a walk in double precision that visits every patch of the sheets.
struct ReliefComparison {
  std::size_t rays = 0, hits = 0;
  std::size_t wrong = 0;     ///< off by more than 1e-3 of the map's cell, or a hole, or a hit of nothing
  std::size_t touching = 0;  ///< the same of rays that come no deeper than 1e-3 cells below the ground before
  double worst_cells = 0.0;  ///< across the surface, of the others
};

/// Adds a failure for each of the first few wrong rays. Where a ray enters the next sheet below its surface,
/// it hits.
ReliefComparison compare(const std::vector<PostSheet>& sheets, const Camera& camera,
                         const std::vector<TerrainHit>& hits);

}  // namespace offing::test
