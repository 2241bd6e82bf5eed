#pragma once

#include <vector>

#include "host/base/triangle_mesh.h"

namespace offing::bodies {

/// A hull as it looks from below and from above: heights in its mesh's axes over a grid of columns, which
/// reaches one column beyond the hull on all sides.
struct HullMap {
  static constexpr int columns = 192, rows = 96;  ///< along x and along z

  double low_x_m = 0.0, low_z_m = 0.0;  ///< middle of column (0, 0)
  double cell_x_m = 0.0, cell_z_m = 0.0;
  // Each [rows][columns] m, row-major. Where a column misses the hull, bottom is +inf, the others -inf.
  std::vector<float> bottom_m;  ///< the lowest place
  std::vector<float> top_m;     ///< the highest place
  /// How high the water beside the hull may stand before it runs in: the highest place or, in an open boat,
  /// the lowest part of the rim around.
  std::vector<float> rim_m;
};

/// Of a mesh that has faces.
HullMap map_of_hull(const TriangleMesh& mesh);

/// Whether the hull is open above, so that water would stand in it.
bool is_open(const HullMap& map);

}  // namespace offing::bodies
