#pragma once

#include <cstdint>
#include <vector>

namespace offing {

/// A picture of the ground from above, placed on a height map: row 0 is north.
struct ColourMap {
  int columns = 0, rows = 0;
  /// [rows][columns][4] red, green, blue (sRGB) and coverage: 255 where the ground has this colour, 0 where
  /// the picture does not know it. Not premultiplied.
  std::vector<std::uint8_t> rgba;
  /// The edges of the picture in cells of the height map, from its first post.
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

}  // namespace offing
