#pragma once

#include <filesystem>

#include "host/io/height_maps/source_heights.h"

namespace offing::height_maps {

/// Heights of a raster that open_raster() opens, with its voids, its unit of height and where its posts lie;
/// south-up rasters are turned over, or refused where somebody takes their rows. Throws Error(bad_input) as
/// read_height_map() says.
SourceHeights read_gdal_heights(const std::filesystem::path& path, const HeightMapOptions& options,
                                const RowTaker& taker = {});

}  // namespace offing::height_maps
