#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace offing {

/// Throws Error(bad_usage) unless a name ends in one of these, such as ".png": a file must be what its name
/// says. The hint is the name with the first of them.
void require_extension(const std::filesystem::path& path, std::initializer_list<std::string_view> extensions);

}  // namespace offing
