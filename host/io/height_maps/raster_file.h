#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "host/io/file_trust.h"
#include "host/io/height_maps/gdal_session.h"

namespace offing::height_maps {

/// Where rasters lie that Offing keeps in GDAL's memory.
inline constexpr std::string_view own_memory = "/vsimem/";

/// Opens a raster of a plain format (plain_formats()); null for what is none. A VRT is opened if a person has
/// named it and check_raster() has nothing against it. ASCII grids hold all their heights, and those of
/// integers are read as real numbers. Throws Error(bad_input) as check_raster().
Dataset open_raster(const std::filesystem::path& path, const FileTrust& trust);

/// The files that GDAL has read for a raster that is open.
std::vector<std::filesystem::path> files_of_dataset(GDALDatasetH raster);

/// Whether a file is a raster of a plain format.
bool is_plain_raster(const std::filesystem::path& path);

/// What check_raster() has returned for each file; nothing for those that it still checks.
using CheckedRasters = std::map<std::filesystem::path, std::optional<int>>;

/// Throws Error(bad_input) for rasters that lead where they may not: masks and overviews beside them are
/// GeoTIFF, and a VRT joins plain rasters of this machine, as gdalbuildvrt and gdal_translate write it. With
/// Trust::untrusted, all of that lies in the file's folder or below. ASCII grids must hold all their heights,
/// as integers if GDAL takes them for such. Returns how many VRTs are in one another: 0 for a plain raster.
/// `checked` spares files that were checked before; `depth` counts the VRTs that led here.
int check_raster(const std::filesystem::path& path, Trust trust, CheckedRasters& checked, int depth = 0);

/// The same for a raster of a plain format that is joined to others. Integers of ASCII grids may be any
/// numbers: returns whether it is one that must be read by the option DATATYPE=Float64.
bool is_real_grid(const std::filesystem::path& path, Trust trust);

/// check_raster() for a file that is a VRT.
int check_vrt(const std::filesystem::path& path, Trust trust, CheckedRasters& checked, int depth);

/// What the heights of an ASCII grid are.
enum class AsciiNumbers { real, integers };

/// Throws Error(bad_input) with the line unless the heights of an ASCII grid (ESRI, GRASS) are there and are
/// such numbers: GDAL takes what is missing for 0, and reads other words among integers as 0.
void check_ascii_grid(const std::filesystem::path& path, std::size_t heights, AsciiNumbers numbers);

}  // namespace offing::height_maps
