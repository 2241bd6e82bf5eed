#pragma once

#include <filesystem>

#include "host/io/file_trust.h"

namespace offing::height_maps {

/// All rasters of a folder as one, for GDAL to open while this object lives.
class Mosaic {
 public:
  /// Throws Error(bad_input) if the folder holds none, they do not fit together, or as check_raster().
  Mosaic(const std::filesystem::path& folder, Trust trust);
  Mosaic(const Mosaic&) = delete;
  Mosaic& operator=(const Mosaic&) = delete;
  ~Mosaic();

  /// A file in GDAL's own memory.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace offing::height_maps
