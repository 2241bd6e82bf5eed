#pragma once

#include <filesystem>
#include <vector>

#include "host/io/file_trust.h"

namespace offing::height_maps {

/// The files that GDAL reads for a raster: the file itself, those beside it (.aux.xml, .tfw, .ovr), the
/// sources of a VRT. Empty for a file that is no raster, or one that open_raster() refuses.
std::vector<std::filesystem::path> files_of_raster(const std::filesystem::path& path, Trust trust);

}  // namespace offing::height_maps
