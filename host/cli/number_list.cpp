#include "host/cli/number_list.h"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "host/base/argument.h"

namespace offing::cli {
namespace {

std::optional<double> finite_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::vector<double> read_numbers(std::string_view flag, std::string_view text, std::size_t count,
                                 std::string_view form, std::string_view example) {
  std::vector<double> numbers;
  for (std::string_view rest = text; numbers.size() <= count;) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> number = finite_number(rest.substr(0, comma));
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

double read_number(std::string_view flag, std::string_view text, double low, double high,
                   std::string_view example) {
  const std::optional<double> number = finite_number(text);
  if (number && *number >= low && *number <= high) return *number;
  throw bad_argument(flag, fmt::format("a number within [{:g}, {:g}]", low, high), text, example);
}

}  // namespace offing::cli
