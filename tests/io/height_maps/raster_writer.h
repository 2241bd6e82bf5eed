#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace offing::test {

/// A raster that a test writes through GDAL, on its own way past Offing's readers.
struct Raster {
  int columns = 0, rows = 0;
  std::vector<std::vector<double>> bands;  ///< each [rows][columns]
  std::string type = "Float32";            ///< as GDAL names it
  std::optional<std::array<double, 6>> geotransform;
  std::string coordinate_system;  ///< as EPSG:n
  std::optional<double> nodata;
  std::string unit;
  bool is_point = false;
  std::vector<std::string> creation_options;
};

/// One band of columns x rows posts with the heights that `height` (column, row) gives.
Raster raster_of(int columns, int rows, const std::function<double(int, int)>& height);

/// Writes it with the driver of that short name; by way of memory, for those that only copy.
void write_raster(const std::filesystem::path& path, const std::string& driver, const Raster& raster);

}  // namespace offing::test
