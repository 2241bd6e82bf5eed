#pragma once

#include <filesystem>

/// Whether the name of a file is taken.
namespace offing {

/// Whether a name is taken by a file, a folder or anything else. Throws Error(file) where that cannot be
/// found out, as of a name that is too long.
bool is_there(const std::filesystem::path& path);
/// The same, also for a link that leads nowhere: whether a new file of this name would replace something.
bool is_taken(const std::filesystem::path& path);

}  // namespace offing
