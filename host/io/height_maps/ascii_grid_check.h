#pragma once

#include <cstddef>
#include <filesystem>

namespace offing::height_maps {

/// Throws Error(bad_input) with the line unless the heights of an ASCII grid (ESRI, GRASS) are there and are
/// numbers: GDAL takes what is missing for 0.
void check_ascii_grid(const std::filesystem::path& path, std::size_t heights);

}  // namespace offing::height_maps
