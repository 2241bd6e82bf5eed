#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace offing {

/// What a file should be, for the errors.
struct FileExpectation {
  std::string_view kind;                                      ///< "a wave spectrum file"
  std::size_t most_bytes;                                     ///< larger ones are refused
  std::string_view hint_of_size = "cut the file into parts";  ///< what to do about them
};

/// All bytes of a file. Throws Error(bad_input) if there is no such file, it cannot be read, is a folder or a
/// device, or is too large.
std::string read_whole_file(const std::filesystem::path& path, const FileExpectation& expectation);

}  // namespace offing
