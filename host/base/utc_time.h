#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace offing {

/// A moment of the Gregorian calendar, UTC, to the second; every day has 86400 of them. One made by default
/// is the epoch J2000.
struct UtcTime {
  int year = 2000;
  int month = 1;  ///< 1 ... 12
  int day = 1;    ///< 1 ... days of the month
  int hour = 12;  ///< 0 ... 23; 24 at the very end of a day
  int minute = 0;
  int second = 0;  ///< 0 ... 59

  auto operator<=>(const UtcTime&) const = default;  // NOLINT(modernize-use-nullptr): false alarm of tidy 14
};

/// ISO 8601, "2020-06-08T03:50Z", with seconds only if they are not 0. Nothing if there is no such day or
/// hour; hour 24 of a day is hour 0 of the next, as some models write it.
std::optional<std::string> iso_time(const UtcTime& time);

/// Reads what iso_time() writes; nothing if `text` is not of that form.
std::optional<UtcTime> parse_iso_time(std::string_view text);

/// Seconds since 1970-01-01T00:00Z and back. The day must exist; years 1 to 9999.
std::int64_t unix_seconds(const UtcTime& time);
UtcTime from_unix_seconds(std::int64_t seconds);

/// True if the day exists, in years 1 to 9999, and the hour, minute and second are within a day (24:00:00
/// is).
bool is_valid(const UtcTime& time);

}  // namespace offing
