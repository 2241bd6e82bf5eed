#include "host/io/height_maps/elevation_rgb.h"

namespace offing::height_maps {

std::optional<double> height_of_rgb(HeightEncoding encoding, std::uint8_t red, std::uint8_t green,
                                    std::uint8_t blue) {
  const int code = 65536 * red + 256 * green + blue;
  if (code == 0) {
    return std::nullopt;
  }
  return encoding == HeightEncoding::mapbox ? -10000.0 + 0.1 * code : code / 256.0 - 32768.0;
}

}  // namespace offing::height_maps
