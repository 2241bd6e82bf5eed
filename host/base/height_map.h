#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace offing {

/// Where the posts of a height map lie in a coordinate system of the world's: post (column, row) at
/// (origin_x + column * step_x, origin_y + row * step_y), in the units of that system. step_y is negative
/// where rows go south.
struct Georeference {
  std::string coordinate_system;  ///< as WKT; empty where the file names none
  double origin_x = 0.0, origin_y = 0.0;
  double step_x = 0.0, step_y = 0.0;
};

/// Heights of the ground at the posts of a regular grid: each value is the height at its post, not of a cell
/// around it, and between posts the ground is bilinear. Row 0 is the north edge; x grows east with the
/// column, z south with the row.
struct HeightMap {
  int columns = 0, rows = 0;                    ///< at least 2
  double spacing_x_m = 1.0, spacing_z_m = 1.0;  ///< between neighbouring posts, above 0
  std::vector<float> heights_m;                 ///< [rows][columns], finite, also where nothing was measured
  /// [rows][columns], 1 where the source had no height and heights_m is filled in; empty if it had all.
  std::vector<std::uint8_t> is_void;
  Georeference georeference;  ///< step 0 where the source has none

  /// Place of a post in heights_m and is_void.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

}  // namespace offing
