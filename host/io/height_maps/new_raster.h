#pragma once

#include <filesystem>
#include <initializer_list>

#include "host/base/height_map.h"
#include "host/io/height_maps/gdal_session.h"

namespace offing::height_maps {

/// Throws Error(file) with what GDAL has said.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const GdalSession& session);

/// Of a GeoTIFF that is to be made.
struct NewRaster {
  std::filesystem::path name;       ///< for messages
  std::filesystem::path temporary;  ///< where it is written
  int columns, rows;
  GDALDataType type;
  Georeference georeference;  ///< posts stand at the centres of samples
  std::initializer_list<const char*> options;
};

/// Makes a raster of one band. Throws Error(file).
Dataset create_raster(const NewRaster& raster, const GdalSession& session);

}  // namespace offing::height_maps
