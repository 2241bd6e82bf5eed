#pragma once

#include <cstddef>
#include <filesystem>

namespace offing::height_maps {

enum class AsciiNumbers { real, integers };

/// Throws Error(bad_input) with the line unless the heights of an ASCII grid (ESRI, GRASS) are there and are
/// such numbers: GDAL takes what is missing for 0, and reads other words among integers as 0.
void check_ascii_grid(const std::filesystem::path& path, std::size_t heights, AsciiNumbers numbers);

}  // namespace offing::height_maps
