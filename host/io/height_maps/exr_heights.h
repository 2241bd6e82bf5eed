#pragma once

#include <filesystem>

#include "host/io/height_maps/source_heights.h"

namespace offing::height_maps {

/// Heights of one channel of an EXR: the one that is asked for, the only one, or the first of height, Y, Z
/// and R that there is. Throws Error(bad_input) where that leaves none, and as read_exr.
SourceHeights read_exr_heights(const std::filesystem::path& path, const HeightMapOptions& options);

}  // namespace offing::height_maps
