#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include "tests/fuzz/expect.h"
#include "tests/io/temporary_folder.h"

namespace offing::fuzz {

/// A file for readers that take a path, in a folder of its own that goes when the process ends.
/// run_fuzzers.sh sets TMPDIR to a folder in memory.
class InputFile {
 public:
  explicit InputFile(std::string_view name) : path_(folder_.path() / name) {}

  const std::filesystem::path& folder() const { return folder_.path(); }
  const std::filesystem::path& path() const { return path_; }

  /// Replaces what the file holds.
  void hold(std::span<const std::uint8_t> bytes) const {
    std::ofstream file(path_, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    expect(bool(file));
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

}  // namespace offing::fuzz
