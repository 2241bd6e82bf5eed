#include "host/base/argument.h"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace offing {
namespace {

std::optional<std::int64_t> whole(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

std::optional<double> finite(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// The two whole numbers on both sides of `separator`.
std::optional<std::pair<std::int64_t, std::int64_t>> pair_of(std::string_view text, char separator) {
  const std::size_t split = text.find(separator);
  if (split == std::string_view::npos) {
    return std::nullopt;
  }
  const auto first = whole(text.substr(0, split));
  const auto second = whole(text.substr(split + 1));
  if (!first || !second) {
    return std::nullopt;
  }
  return std::pair{*first, *second};
}

}  // namespace

Error bad_argument(std::string_view flag, std::string_view expected, std::string_view got,
                   std::string_view example) {
  return Error(ErrorKind::bad_usage,
               fmt::format("{}: expected {}, got \"{}\"", flag, expected, got.substr(0, 60)),
               fmt::format("write {} {}", flag, example));
}

std::int64_t read_whole(std::string_view flag, std::string_view text, std::int64_t low, std::int64_t high,
                        std::string_view example) {
  const auto value = whole(text);
  if (!value || *value < low || *value > high) {
    throw bad_argument(flag, fmt::format("a whole number within [{}, {}]", low, high), text, example);
  }
  return *value;
}

double read_number(std::string_view flag, std::string_view text, std::string_view unit, double low,
                   double high, std::string_view example) {
  const std::optional<double> value = finite(text);
  if (!value || *value < low || *value > high) {
    const std::string in_unit = unit.empty() ? "" : fmt::format(" in {}", unit);
    throw bad_argument(flag, fmt::format("a number{} within [{:g}, {:g}]", in_unit, low, high), text,
                       example);
  }
  return *value;
}

std::vector<double> read_numbers(std::string_view flag, std::string_view text, std::size_t count,
                                 std::string_view form, std::string_view example) {
  std::vector<double> numbers;
  for (std::string_view rest = text; numbers.size() <= count;) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> number = finite(rest.substr(0, comma));
    if (!number) break;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) {
      if (numbers.size() == count) return numbers;
      break;
    }
    rest.remove_prefix(comma + 1);
  }
  throw bad_argument(flag, form, text, example);
}

FrameRange read_frame_range(std::string_view flag, std::string_view text) {
  constexpr std::int64_t largest = 9'999'999;
  auto ends = pair_of(text, ':');
  if (const auto single = whole(text)) {
    ends = std::pair{*single, *single};
  }
  if (!ends || ends->first < 0 || ends->second < ends->first || ends->second > largest) {
    throw bad_argument(flag, fmt::format("A:B with 0 <= A <= B <= {}", largest), text, "0:47");
  }
  return {static_cast<int>(ends->first), static_cast<int>(ends->second)};
}

Share read_share(std::string_view flag, std::string_view text) {
  constexpr std::int64_t largest = 100'000;
  const auto numbers = pair_of(text, '/');
  if (!numbers || numbers->first < 1 || numbers->second < numbers->first || numbers->second > largest) {
    throw bad_argument(flag, fmt::format("i/n with 1 <= i <= n <= {}", largest), text, "1/4");
  }
  return {static_cast<int>(numbers->first - 1), static_cast<int>(numbers->second)};
}

}  // namespace offing
