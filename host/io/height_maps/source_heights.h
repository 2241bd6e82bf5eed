#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/base/height_map.h"
#include "host/io/height_maps/read_height_map.h"

/// What readers of height maps hand over: heights as the file has them, whole or row by row.
namespace offing::height_maps {

struct SourceHeights;

/// Who takes rows as they are read, instead of all of a map: `begin` gets what is known before the first row,
/// `rows` whole rows of heights and voids in order. Empty functions: nobody.
struct RowTaker {
  std::function<void(const SourceHeights&)> begin;
  std::function<void(std::span<const float>, std::span<const std::uint8_t>)> rows;
};

/// Heights as a reader hands them over: voids marked, spacing and fill still to be settled.
struct SourceHeights {
  int columns = 0, rows = 0;
  std::vector<float> heights_m;       ///< [rows][columns], in the order of the file; 0 in voids
  std::vector<std::uint8_t> is_void;  ///< [rows][columns]
  std::optional<Georeference> georeference;
  std::string format, sample_type;
  SampleExtent sample_extent = SampleExtent::unknown;
  RowTaker taker;
  std::size_t posts_taken = 0;
  bool declares_voids = false;   ///< the file says what marks them
  double likely_void = 0.0;      ///< a sample that often marks voids, and was taken for a height
  std::size_t likely_voids = 0;  ///< how many posts have such a sample
};

/// The farthest from 0 m that a height may be: rays are exact up to there.
inline constexpr double farthest_height_m = 1e6;

/// From a sample of the file to metres.
struct HeightScale {
  double factor = 1.0, offset_m = 0.0;
  float to_metres(double sample) const { return static_cast<float>(sample * factor + offset_m); }
};

/// Throws Error(bad_input) unless the map is at least 2x2, Error(out_of_memory) if it would not fit into the
/// memory that is free.
void check_size(const std::filesystem::path& path, std::int64_t columns, std::int64_t rows);

/// A map of that size without rows. Memory is taken as rows arrive: a header may promise more than there is.
/// With a taker only its rows need memory.
SourceHeights begin_heights(const std::filesystem::path& path, std::int64_t columns, std::int64_t rows,
                            const RowTaker& taker = {});

/// Gives the rows that have come in to the taker, if there is one.
void hand_over_rows(SourceHeights& source);

/// Adds the next post. Throws Error(bad_input) with row and column if the height is not finite or too far.
void append_height(const std::filesystem::path& path, SourceHeights& source, float height_m);
inline void append_void(SourceHeights& source) {
  source.heights_m.push_back(0.0f);
  source.is_void.push_back(1);
}

/// Adds the next post: a void where the sample equals `nodata` (NaN equals NaN), else its height. Throws as
/// append_height().
void append_sample(const std::filesystem::path& path, SourceHeights& source, double sample,
                   const HeightScale& scale, const std::optional<double>& nodata);

/// Heights of one channel of an EXR: the one that is asked for, the only one, or the first of height, Y, Z
/// and R that there is. Throws Error(bad_input) where that leaves none, and as read_exr.
SourceHeights read_exr_heights(const std::filesystem::path& path, const HeightMapOptions& options);

/// Heights of a raster that open_raster() opens, with its voids, its unit of height and where its posts lie;
/// south-up rasters are turned over, or refused where somebody takes their rows. Throws Error(bad_input) as
/// read_height_map() says.
SourceHeights read_gdal_heights(const std::filesystem::path& path, const HeightMapOptions& options,
                                const RowTaker& taker = {});

/// Whether the name ends as those of files without a header do: .r16, .r32, .raw, .bin.
bool is_raw_name(const std::filesystem::path& path);

/// Heights of a file without a header, row by row from the north. Throws Error(bad_input) if the options
/// state no size or type, or the file has not just as many bytes as they take.
SourceHeights read_raw_heights(const std::filesystem::path& path, const HeightMapOptions& options,
                               const RowTaker& taker = {});

}  // namespace offing::height_maps
