#pragma once

#include <filesystem>

namespace offing::height_maps {

/// Throws Error(bad_input) for what is no regular file, Error(file) for one that may not be read; `expected`
/// says what it should have been, such as "a height map", `folder_hint` what to do with a folder. GDAL would
/// open folders, addresses of servers and strings that describe rasters too.
void require_readable_file(const std::filesystem::path& path, const char* expected,
                           const char* folder_hint = "give the path of a file");

}  // namespace offing::height_maps
