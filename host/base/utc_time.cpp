#include "host/base/utc_time.h"

#include <charconv>
#include <chrono>

#include <fmt/format.h>

namespace offing {
namespace {

std::chrono::year_month_day calendar_day(const UtcTime& time) {
  return std::chrono::year(time.year) / std::chrono::month(static_cast<unsigned>(time.month)) /
         std::chrono::day(static_cast<unsigned>(time.day));
}

}  // namespace

bool is_valid(const UtcTime& time) {
  if (time.year < 1 || time.year > 9999 || time.month < 1 || time.month > 12 || time.day < 1 || time.day > 31)
    return false;
  if (time.minute < 0 || time.minute > 59 || time.second < 0 || time.second > 59 || time.hour < 0)
    return false;
  const bool is_within_day = time.hour < 24 || (time.hour == 24 && time.minute == 0 && time.second == 0);
  return is_within_day && calendar_day(time).ok();
}

std::int64_t unix_seconds(const UtcTime& time) {
  const auto days = std::chrono::sys_days(calendar_day(time)).time_since_epoch().count();
  return ((std::int64_t{days} * 24 + time.hour) * 60 + time.minute) * 60 + time.second;
}

UtcTime from_unix_seconds(std::int64_t seconds) {
  const std::chrono::sys_seconds moment{std::chrono::seconds(seconds)};
  const auto day_start = std::chrono::floor<std::chrono::days>(moment);
  const std::chrono::year_month_day day{day_start};
  const auto in_day = static_cast<int>((moment - day_start).count());
  return {int(day.year()),
          static_cast<int>(unsigned(day.month())),
          static_cast<int>(unsigned(day.day())),
          in_day / 3600,
          in_day / 60 % 60,
          in_day % 60};
}

std::optional<std::string> iso_time(const UtcTime& time) {
  if (!is_valid(time)) return std::nullopt;
  const UtcTime t = from_unix_seconds(unix_seconds(time));
  if (t.year > 9999) return std::nullopt;
  std::string text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}", t.year, t.month, t.day, t.hour, t.minute);
  if (t.second != 0) text += fmt::format(":{:02}", t.second);
  return text + "Z";
}

std::optional<UtcTime> parse_iso_time(std::string_view text) {
  // d = digit, everything else as it stands
  constexpr std::string_view form = "dddd-dd-ddTdd:dd:ddZ";
  const bool has_seconds = text.size() == form.size();
  if (!has_seconds && text.size() != form.size() - 3) return std::nullopt;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    if (form[i] == 'd' ? !is_digit : text[i] != form[i]) return std::nullopt;
  }
  if (text.back() != 'Z') return std::nullopt;
  const auto field = [&](std::size_t at, std::size_t length) {
    int value = 0;
    std::from_chars(text.data() + at, text.data() + at + length, value);
    return value;
  };
  const UtcTime time{field(0, 4),  field(5, 2),  field(8, 2),
                     field(11, 2), field(14, 2), has_seconds ? field(17, 2) : 0};
  return is_valid(time) ? std::optional(time) : std::nullopt;
}

}  // namespace offing
