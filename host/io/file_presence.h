#pragma once

#include <filesystem>

namespace offing {

/// Whether a name is taken by a file, a folder or anything else. Throws Error(file) where that cannot be
/// found out, as of a name that is too long.
bool is_there(const std::filesystem::path& path);

}  // namespace offing
