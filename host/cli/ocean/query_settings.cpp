#include "host/cli/ocean/query_settings.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/parameter_check.h"

namespace offing::cli {

namespace {

constexpr double most_times = 1e7;

/// `count` finite numbers with this separator between them.
template <std::size_t count>
std::optional<std::array<double, count>> numbers_in(std::string_view text, char separator) {
  std::array<double, count> numbers{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (at == end || *at++ != separator)) {
      return std::nullopt;
    }
    const auto [after, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc{} || !std::isfinite(numbers[i])) {
      return std::nullopt;
    }
    at = after;
  }
  return at == end ? std::optional(numbers) : std::nullopt;
}

}  // namespace

TimeRange read_time_range(std::string_view flag, std::string_view text, std::string_view example) {
  const auto numbers = numbers_in<3>(text, ':');
  if (numbers) {
    const auto [first_s, last_s, step_s] = *numbers;
    // A step that does not divide the range in binary still reaches its end.
    const double steps = std::floor((last_s - first_s) / step_s + 1e-6);
    if (first_s >= -largest_time_s && last_s <= largest_time_s && first_s <= last_s && step_s > 0.0 &&
        steps < most_times) {
      return {.first_s = first_s, .step_s = step_s, .count = static_cast<std::int64_t>(steps) + 1};
    }
  }
  throw bad_argument(flag,
                     fmt::format("A:B:DT in s with {:g} <= A <= B <= {:g}, DT > 0 and at most {:g} times",
                                 -largest_time_s, largest_time_s, most_times),
                     text, example);
}

scene::Parameter velocity_depth_facts(std::string_view help) {
  return {
      .key = "velocity_depth_m", .unit = "m", .low = 0.0, .high = deepest_m, .help = help, .example = "2.5"};
}

ocean::WaterPoint read_point(std::string_view flag, std::string_view text) {
  const auto numbers = numbers_in<2>(text, ',');
  if (!numbers || std::abs((*numbers)[0]) > farthest_point_m || std::abs((*numbers)[1]) > farthest_point_m) {
    throw bad_argument(flag, fmt::format("X,Z in m within [-{0:g}, {0:g}]", farthest_point_m), text,
                       "12.5,-40");
  }
  return {.x_m = (*numbers)[0], .z_m = (*numbers)[1]};
}

}  // namespace offing::cli
