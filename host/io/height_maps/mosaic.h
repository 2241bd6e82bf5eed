#pragma once

#include <filesystem>

namespace offing::height_maps {

/// All rasters of a folder as one, for GDAL to open while this object lives.
class Mosaic {
 public:
  /// Throws Error(bad_input) if the folder holds none, or they do not fit together.
  explicit Mosaic(const std::filesystem::path& folder);
  Mosaic(const Mosaic&) = delete;
  Mosaic& operator=(const Mosaic&) = delete;
  ~Mosaic();

  /// A file in GDAL's own memory.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace offing::height_maps
