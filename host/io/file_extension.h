#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace offing {

/// The extension of a name in lower case: ".png" of "A.PNG".
std::string lower_extension(const std::filesystem::path& path);

/// Throws Error(bad_usage) unless a name ends in one of these, such as ".png": a file must be what its name
/// says. The hint is the name with the first of them.
void require_extension(const std::filesystem::path& path, std::initializer_list<std::string_view> extensions);

/// Whether a name ends as one of a GIS's vector formats, such as .shp.
bool is_vector_name(const std::filesystem::path& path);

/// Throws Error(bad_usage) for a vector name that does not end in one of these: the file would be CSV.
void refuse_vector_name(const std::filesystem::path& path,
                        std::initializer_list<std::string_view> extensions);

}  // namespace offing
