#include "host/io/spectra/netcdf_units.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "host/base/utc_time.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/swan_spectra.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

// Lower case without blanks and marks of powers, so that "m**2 s rad^-1" and "m2 s rad-1" read the same.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == ' ' || c == '*' || c == '^' || c == '.' || c == '_') continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

// Takes the first of these that `text` starts with; longer ones must stand first.
bool take_any(std::string_view& text, std::initializer_list<std::string_view> prefixes) {
  for (const std::string_view prefix : prefixes) {
    if (!text.starts_with(prefix)) continue;
    text.remove_prefix(prefix.size());
    return true;
  }
  return false;
}

}  // namespace

std::optional<DensityUnit> parse_density_unit(std::string_view text) {
  const std::string all = plain(text);
  std::string_view rest = all;
  DensityUnit unit{1.0, false};
  if (take_any(rest, {"j/m2", "jm-2"})) {
    unit.in_si /= energy_of_variance_jpm4;
  } else if (!take_any(rest, {"m2"})) {
    return std::nullopt;
  }
  if (!take_any(rest, {"hz-1", "/hz", "s"})) return std::nullopt;
  if (rest.empty()) return unit;
  unit.is_directional = true;
  if (take_any(rest, {"degrees-1", "degree-1", "degr-1", "deg-1", "/degrees", "/degree", "/degr", "/deg"})) {
    unit.in_si /= degree_rad;
  } else if (!take_any(rest, {"radians-1", "radian-1", "rad-1", "/radians", "/radian", "/rad"})) {
    return std::nullopt;
  }
  return rest.empty() ? std::optional(unit) : std::nullopt;
}

std::optional<double> parse_frequency_unit(std::string_view text) {
  const std::string unit = plain(text);
  if (unit == "s-1" || unit == "1/s" || unit == "hz" || unit == "hertz") return 1.0;
  if (unit == "rads-1" || unit == "rad/s" || unit == "radians/s") return 1.0 / (2.0 * std::numbers::pi);
  return std::nullopt;
}

std::optional<double> parse_direction_unit(std::string_view text) {
  const std::string unit = plain(text);
  if (unit.starts_with("deg")) return degree_rad;
  if (unit.starts_with("rad")) return 1.0;
  return std::nullopt;
}

std::string TimeUnit::iso_time(double value) const {
  const double since = std::round(value * seconds);
  // The years 1 to 9999, so that the sum fits and has a calendar date.
  constexpr double first_unix = -62135596800.0;
  constexpr double last_unix = 253402300799.0;
  const double unix_time = static_cast<double>(origin_unix) + since;
  if (!(unix_time >= first_unix && unix_time <= last_unix)) return {};
  return offing::iso_time(from_unix_seconds(origin_unix + static_cast<std::int64_t>(since))).value_or("");
}

std::optional<TimeUnit> parse_time_unit(std::string_view text) {
  const std::string_view unit = take_word(text);
  TimeUnit result{};
  if (unit == "second" || unit == "seconds" || unit == "sec" || unit == "s") {
    result.seconds = 1.0;
  } else if (unit == "minute" || unit == "minutes" || unit == "min") {
    result.seconds = 60.0;
  } else if (unit == "hour" || unit == "hours" || unit == "h") {
    result.seconds = 3600.0;
  } else if (unit == "day" || unit == "days" || unit == "d") {
    result.seconds = 86400.0;
  } else {
    return std::nullopt;
  }
  if (take_word(text) != "since") return std::nullopt;

  // Year, month, day and perhaps hour, minute, second, with any marks between them.
  double fields[6] = {};
  int count = 0;
  while (count < 6) {
    const std::size_t digit = text.find_first_of("0123456789");
    if (digit == std::string_view::npos) break;
    text.remove_prefix(digit);
    // "01-01" would be a number and a negative one: only digits belong to a field, or a fraction of seconds.
    const std::size_t end = text.find_first_not_of(count == 5 ? "0123456789." : "0123456789");
    std::string_view field = text.substr(0, end);
    const std::optional<double> value = take_number(field);
    if (!value || *value > 9999.0) return std::nullopt;
    fields[count++] = *value;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end);
  }
  if (count < 3) return std::nullopt;
  const UtcTime origin{static_cast<int>(fields[0]), static_cast<int>(fields[1]), static_cast<int>(fields[2]),
                       static_cast<int>(fields[3]), static_cast<int>(fields[4]), static_cast<int>(fields[5])};
  if (!is_valid(origin)) return std::nullopt;
  result.origin_unix = unix_seconds(origin);
  return result;
}

}  // namespace offing::spectra
