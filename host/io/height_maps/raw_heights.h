#pragma once

#include <filesystem>

#include "host/io/height_maps/source_heights.h"

namespace offing::height_maps {

/// Whether the name ends as those of files without a header do: .r16, .r32, .raw, .bin.
bool is_raw_name(const std::filesystem::path& path);

/// Heights of a file without a header, row by row from the north. Throws Error(bad_input) if the options
/// state no size or type, or the file has not just as many bytes as they take.
SourceHeights read_raw_heights(const std::filesystem::path& path, const HeightMapOptions& options,
                               const RowTaker& taker = {});

}  // namespace offing::height_maps
