#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/base/height_map.h"
#include "host/io/height_maps/new_raster.h"
#include "host/terrain/analysis/horizons.h"

namespace offing::cli {

/// Of floats, and of bytes that are 0 or 255.
inline constexpr float float_nodata = -9999.0f;
inline constexpr std::uint8_t byte_nodata = 128;

/// A raster of bands where a map lies, written in bands of its rows. Posts without a height get nodata.
inline BandedRaster raster_on_map(const HeightMap& map, const terrain::RowBand& first, bool has_bytes,
                                  std::vector<BandedRaster::Band> bands) {
  const double nodata = has_bytes ? static_cast<double>(byte_nodata) : static_cast<double>(float_nodata);
  return {.columns = map.columns,
          .rows = map.rows,
          .rows_at_once = (first.rows + 15) / 16 * 16,
          .has_bytes = has_bytes,
          .georeference = map.georeference,
          .nodata = map.is_void.empty() ? std::nullopt : std::optional(nodata),
          .bands = std::move(bands)};
}

/// Sets the values [rows][columns] of a band of rows to nodata where the map has voids.
template <class T>
void mark_voids(const HeightMap& map, const terrain::RowBand& band, T nodata, std::span<T> values) {
  if (map.is_void.empty()) return;
  const auto* const is_void = map.is_void.data() + map.index(0, band.first_row);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_void[i] != 0) values[i] = nodata;
  }
}

/// Least, mean and greatest of the values that a raster was given, but for nodata.
class RasterRange {
 public:
  void add(std::span<const float> values) {
    for (const float value : values) {
      if (value == float_nodata) continue;
      low_ = count_ == 0 ? value : std::min(low_, value);
      high_ = count_ == 0 ? value : std::max(high_, value);
      sum_ += static_cast<double>(value);
      ++count_;
    }
  }
  double low() const { return static_cast<double>(low_); }
  double high() const { return static_cast<double>(high_); }
  double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }

 private:
  float low_ = 0.0f, high_ = 0.0f;
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

}  // namespace offing::cli
