#pragma once

#include <cstdint>
#include <optional>

#include "host/io/height_maps/height_map_options.h"

namespace offing::height_maps {

/// Height in m that three bytes stand for; none for black, which both encodings leave to places without data
/// (-10000 m and -32768 m). `encoding` is mapbox or terrarium.
/// Sources: Mapbox, "Access elevation data" (Terrain-RGB); Tilezen Joerd, docs/formats.md (terrarium).
std::optional<double> height_of_rgb(HeightEncoding encoding, std::uint8_t red, std::uint8_t green,
                                    std::uint8_t blue);

}  // namespace offing::height_maps
