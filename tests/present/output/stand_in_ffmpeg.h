#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/io/temporary_folder.h"

namespace offing::test {

/// A program by the name of ffmpeg that PATH finds first while this object lives, and what it was given.
class StandInFfmpeg {
 public:
  /// Keeps what it is fed as it is, in the file that it is to write.
  static constexpr const char* keeps_frames = "cat > \"${last#file:}\"";

  explicit StandInFfmpeg(const std::string& deed = keeps_frames) {
    std::ofstream(folder_.path() / "ffmpeg") << "#!/bin/sh\nfor last; do :; done\nprintf '%s\\n' \"$@\" > "
                                             << (folder_.path() / "arguments").string() << "\n"
                                             << deed << "\n";
    std::filesystem::permissions(folder_.path() / "ffmpeg", std::filesystem::perms::owner_all);
    setenv("PATH", (folder_.path().string() + ":" + before_).c_str(), 1);
  }
  StandInFfmpeg(const StandInFfmpeg&) = delete;
  StandInFfmpeg& operator=(const StandInFfmpeg&) = delete;
  ~StandInFfmpeg() { setenv("PATH", before_.c_str(), 1); }

  /// From here on PATH has no program at all.
  void take_away() const { setenv("PATH", (folder_.path() / "nowhere").c_str(), 1); }
  /// A line each.
  std::string arguments() const {
    std::ifstream file(folder_.path() / "arguments");
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  TemporaryFolder folder_;
  std::string before_ = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
};

}  // namespace offing::test
