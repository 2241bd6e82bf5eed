#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "host/base/height_map.h"
#include "host/io/atomic_file.h"

namespace offing {

/// A raster of bytes at the posts of a height map.
struct ByteRaster {
  int columns = 0, rows = 0;
  std::span<const std::uint8_t> values;  ///< [rows][columns], row 0 at the north edge
  Georeference georeference;             ///< of the map; step 0 where it has none
  std::optional<std::uint8_t> nodata;    ///< what marks posts without an answer
};

/// Writes a GeoTIFF of one band, compressed, whole or not at all. Each sample has its post at its centre.
/// Throws Error(bad_usage) if the sizes do not fit each other, Error(file) if it cannot be written.
void write_byte_raster(const std::filesystem::path& path, const ByteRaster& raster,
                       Existing existing = Existing::replace);

}  // namespace offing
