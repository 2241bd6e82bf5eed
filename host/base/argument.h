#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/error.h"

/// Values of flags: numbers, ranges and names of frames, shares of work.
namespace offing {

/// An argument of the command line that cannot be used: "--frames: expected A:B with 0 <= A <= B, got
/// \"9:0\"".
Error bad_argument(std::string_view flag, std::string_view expected, std::string_view got,
                   std::string_view example);

/// A whole number; throws bad_argument() unless it is within [low, high].
std::int64_t read_whole(std::string_view flag, std::string_view text, std::int64_t low, std::int64_t high,
                        std::string_view example);

/// A number in `unit` (empty: without one); throws bad_argument() unless it is within [low, high].
double read_number(std::string_view flag, std::string_view text, std::string_view unit, double low,
                   double high, std::string_view example);

/// Finite numbers between commas, as many as `count`; throws bad_argument() that expects `form` otherwise.
std::vector<double> read_numbers(std::string_view flag, std::string_view text, std::size_t count,
                                 std::string_view form, std::string_view example);

/// Frames first ... last, both included.
struct FrameRange {
  int first = 0;
  int last = 0;
};

/// "A:B" with 0 <= A <= B <= 9999999, or one number for a single frame.
FrameRange read_frame_range(std::string_view flag, std::string_view text);

/// Share `index` (from 0) of `count` equal shares of work.
struct Share {
  int index = 0;
  int count = 1;
};

/// "i/n" with 1 <= i <= n <= 100000.
Share read_share(std::string_view flag, std::string_view text);

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
