#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace offing::present {

/// A name for each frame of a recording, "out_%04d.png": one place for the frame's number, of at least so
/// many digits.
class FrameName {
 public:
  /// Throws Error(bad_usage) unless `pattern` has one %d, %4d or %04d (1 to 9 digits) and ends as pictures
  /// do.
  explicit FrameName(std::string_view pattern);

  std::filesystem::path of(int frame) const;

 private:
  std::string before_, after_;
  int digits_ = 0;
};

}  // namespace offing::present
