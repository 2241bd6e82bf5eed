#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/error.h"

/// Values of flags: numbers, ranges of frames, shares of work.
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

}  // namespace offing
