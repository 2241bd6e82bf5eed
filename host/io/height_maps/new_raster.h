#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "host/base/height_map.h"
#include "host/io/atomic_file.h"

/// GeoTIFFs that are written: bytes and heights at the posts of a map.
namespace offing {

/// A raster of bytes at the posts of a height map.
struct ByteRaster {
  int columns = 0, rows = 0;
  std::span<const std::uint8_t> values;  ///< [rows][columns], row 0 at the north edge
  Georeference georeference;             ///< of the map; step 0 where it has none
  std::optional<std::uint8_t> nodata;    ///< what marks posts without an answer
};

/// Values at the posts of a height map.
struct PostRaster {
  int columns = 0, rows = 0;
  /// [rows][columns], row 0 at the north edge
  std::variant<std::span<const std::uint8_t>, std::span<const std::uint16_t>, std::span<const float>> values;
  Georeference georeference;      ///< of the map; step 0 where it has none
  std::optional<double> nodata;   ///< what marks posts without an answer
  std::string unit, description;  ///< of the band; empty: none
};

/// Writes a GeoTIFF of one band, compressed, whole or not at all. Each sample has its post at its centre.
/// Throws Error(bad_usage) if the sizes do not fit each other, Error(file) if it cannot be written.
void write_byte_raster(const std::filesystem::path& path, const ByteRaster& raster,
                       Existing existing = Existing::replace);
void write_post_raster(const std::filesystem::path& path, const PostRaster& raster,
                       Existing existing = Existing::replace);

/// A raster of several bands at the posts of a height map, to be written some rows at a time.
struct BandedRaster {
  int columns = 0, rows = 0;
  int rows_at_once = 64;   ///< multiple of 16: parts begin at multiples of it, and only the last is shorter
  bool has_bytes = false;  ///< or else floats
  Georeference georeference;     ///< of the map; step 0 where it has none
  std::optional<double> nodata;  ///< what marks posts without an answer
  /// A band of the file.
  struct Band {
    std::string unit, description;  ///< empty: none
  };
  std::vector<Band> bands;
};

/// Writes a GeoTIFF part by part, whole or not at all. Each sample has its post at its centre.
class BandedRasterWriter {
 public:
  BandedRasterWriter() = default;
  BandedRasterWriter(const BandedRasterWriter&) = delete;
  BandedRasterWriter& operator=(const BandedRasterWriter&) = delete;
  virtual ~BandedRasterWriter() = default;

  /// Whole rows [rows][columns] of a band. Throws Error(file).
  virtual void write(std::size_t band, int first_row, std::span<const float> values) = 0;
  virtual void write(std::size_t band, int first_row, std::span<const std::uint8_t> values) = 0;
  /// Publishes the file under its name. Throws Error(file).
  virtual void commit() = 0;
};

/// Throws Error(file) if it cannot be written.
std::unique_ptr<BandedRasterWriter> create_banded_raster(const std::filesystem::path& path,
                                                         const BandedRaster& raster,
                                                         Existing existing = Existing::replace);

/// Heights that are written as a GeoTIFF of floats, row by row, whole or not at all.
class HeightRasterWriter {
 public:
  HeightRasterWriter() = default;
  HeightRasterWriter(const HeightRasterWriter&) = delete;
  HeightRasterWriter& operator=(const HeightRasterWriter&) = delete;
  virtual ~HeightRasterWriter() = default;

  /// Whole rows, from north to south. Throws Error(file).
  virtual void add_rows(std::span<const float> heights_m) = 0;
  /// Publishes the file under its name. Throws Error(file).
  virtual void commit() = 0;
};

/// Begins a map whose posts are so many metres apart, and which lies nowhere in the world. Throws Error(file)
/// if it cannot be written.
std::unique_ptr<HeightRasterWriter> create_height_raster(const std::filesystem::path& path, int columns,
                                                         int rows, double spacing_m,
                                                         Existing existing = Existing::replace);

}  // namespace offing
