#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace offing {

/// A name for each frame of a sequence, "out_%04d.png": one place for the frame's number, of at least so
/// many digits.
class FrameName {
 public:
  /// Throws Error(bad_usage) that names the flag unless `pattern` has one %d, %4d or %04d (1 to 9 digits).
  FrameName(std::string_view flag, std::string_view pattern, std::string_view example);

  std::filesystem::path of(int frame) const;
  /// The same names below a folder, which may hold a %.
  FrameName in(const std::filesystem::path& folder) const;
  /// The frame whose file has this name, without its folder; none for other names, and where the number
  /// stands in the name of a folder.
  std::optional<int> frame_of(std::string_view file_name) const;
  /// What file names begin with, before the number.
  std::string prefix() const;
  /// Whether all frames lie in one folder: the number is in the file's name.
  bool is_one_folder() const { return after_.find('/') == std::string::npos; }

 private:
  std::string before_, after_;
  int digits_ = 0;
};

}  // namespace offing
