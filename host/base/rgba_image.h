#pragma once

#include <cstdint>
#include <vector>

namespace offing {

/// A picture with transparency: rgba [height][width][4] row-major, row 0 at the top, 0 ... 255, not
/// premultiplied. Colours are sRGB.
struct RgbaImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace offing
