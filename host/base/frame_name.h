#pragma once

#include <filesystem>
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

 private:
  std::string before_, after_;
  int digits_ = 0;
};

}  // namespace offing
