#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "host/base/height_map.h"
#include "host/io/height_maps/height_map_options.h"

namespace offing {

/// Where the spacing of a height map comes from.
enum class SpacingSource {
  file,         ///< the coordinate system counts in a length
  latitude,     ///< degrees, at the latitude of the middle row on the system's ellipsoid
  mercator,     ///< the file, divided by the scale of (Web) Mercator at the middle row
  reprojected,  ///< resampled to metres on request
  options,      ///< the caller's
  assumed,      ///< nothing says it: 1 m
};

/// Whether samples of the file stand for points or for the areas around them. In both cases a post is at the
/// centre of its sample.
enum class SampleExtent { unknown, area, point };

/// What the file held and what was done to it.
struct HeightMapSource {
  std::string format;             ///< such as "GeoTIFF"
  std::string sample_type;        ///< such as "Int16"
  std::string coordinate_system;  ///< name of the system of the result; empty where there is none
  SampleExtent sample_extent = SampleExtent::unknown;
  SpacingSource spacing_source = SpacingSource::assumed;
  double projection_scale = 1.0;  ///< metres of the file a metre along x on the ground; of Mercator alone
  std::optional<double> centre_latitude_deg, centre_longitude_deg;  ///< WGS 84
  std::size_t void_posts = 0;
  double void_area_m2 = 0.0;                ///< void_posts times the area of a cell
  float lowest_m = 0.0f, highest_m = 0.0f;  ///< of posts that are no voids
};

/// A height map, and what its file says about it.
struct HeightMapFile {
  HeightMap map;
  HeightMapSource source;
};

/// Reads a height map: GeoTIFF, SRTM HGT (also zipped), USGS DEM, ASCII grid, 8- and 16-bit PNG and the
/// other rasters of docs/terrain.md; EXR; files without a header (.r16, .r32, .raw, .bin) whose size the
/// options state; Mapbox and Terrarium RGB.
///
/// A post stands at the centre of its sample, whether the file says pixel-is-area or pixel-is-point. Rows are
/// put in order from north to south. Heights in feet become metres. Degrees become metres at the latitude of
/// the middle row, unless reproject_to asks for a resampled grid, and those of Mercator become metres of the
/// ground there; they are refused where one spacing would be wrong by more than 5 % at the northern or
/// southern edge.
///
/// Voids (nodata values, masks, transparent pixels, and -32768 in 16-bit files that name no nodata value) are
/// marked in is_void and filled by void_fill.h, or with void_height_m.
///
/// Throws Error(bad_input): no file, a folder, a file that is damaged or cut short, heights that are NaN or
/// infinite, no post at all, fewer than 2x2 posts, no spacing or a spacing of 0; Error(out_of_memory) for a
/// map larger than the memory that is free, before any of it is taken; Error(file) if reading is not allowed.
HeightMapFile read_height_map(const std::filesystem::path& path, const HeightMapOptions& options = {});

/// Logs a warning where nothing has said how far apart the posts are: what is drawn of such a map, or asked
/// of it, is most often wrong.
void warn_of_assumed_spacing(const std::filesystem::path& path, const HeightMapSource& source);

/// Takes heights [columns] m of a row, and is_void [columns] as HeightMap has it.
using TakeRow = std::function<void(std::span<const float> heights_m, std::span<const std::uint8_t> is_void)>;

/// Reads a height map row by row, of any size, with memory for some rows only: a file as read_height_map()
/// reads it, a VRT, or a folder whose rasters together are one map. `begin` gets what is known beforehand
/// (heights, voids and range are not), `row` the heights [columns] m of each row from north to south, and 1
/// where nothing was measured. Voids are filled in bands of 256 rows, each beginning with the last row of the
/// one before; before the first height they are 0. Returns what was read.
///
/// Throws what read_height_map() throws, and Error(bad_input) for south-up rasters and reproject_to.
HeightMapSource stream_height_map(const std::filesystem::path& path, const HeightMapOptions& options,
                                  const std::function<void(const HeightMapFile&)>& begin, const TakeRow& row);

}  // namespace offing
