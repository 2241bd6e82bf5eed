#pragma once

#include <filesystem>

#include "host/base/colour_map.h"
#include "host/base/height_map.h"
#include "host/io/file_trust.h"

namespace offing {

/// Reads a picture of the ground for a height map: GeoTIFF, PNG and the other formats of
/// docs/terrain.md, grey, red-green-blue or with a palette, of 8 or 16 bits, taken as sRGB; transparent
/// pixels and nodata are not covered.
///
/// Where both have a georeference the picture lies by it, resampled (bilinear) if its coordinate system is
/// another than the map's; a picture that names no system has the map's. Otherwise it is stretched from the
/// map's first posts to its last ones.
///
/// Throws Error(bad_input): no file, a folder, a file that is damaged or cut short, no picture, one larger
/// than 2^28 pixels, a rotated one, one that covers nothing of the map; Error(file) if reading is not
/// allowed.
ColourMap read_colour_map(const std::filesystem::path& path, const HeightMap& map,
                          const FileTrust& trust = {});

}  // namespace offing
