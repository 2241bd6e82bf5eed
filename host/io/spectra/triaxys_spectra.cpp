#include "host/io/spectra/triaxys_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/utc_time.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

struct TriaxysHeader {
  std::string station;
  std::string time_utc;
  std::optional<bool> is_directional;
  std::size_t frequency_count = 0;
  std::optional<double> first_hz;
  std::optional<double> step_hz;
  std::optional<double> step_deg;
};

std::optional<int> month_of(std::string_view name) {
  constexpr std::array<std::string_view, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                    "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const auto found = std::find(months.begin(), months.end(), name.substr(0, 3));
  return found == months.end() ? std::nullopt : std::optional(static_cast<int>(found - months.begin()) + 1);
}

// "2018-01-31 21:00(UTC)" or "2018 Feb 09 04:00(UTC)"
std::string parse_triaxys_date(TextCursor& cursor, std::string_view value) {
  std::string words(value.substr(0, value.find('(')));
  for (char& c : words) {
    if (c == '-' || c == ':' || c == '/') c = ' ';
  }
  std::array<int, 6> fields{};
  std::size_t count = 0;
  bool is_sound = true;
  for (std::string_view rest = words; !is_blank(rest) && is_sound;) {
    const std::string_view word = take_word(rest);
    std::string_view digits = word;
    const std::optional<double> number = take_number(digits);
    const std::optional<int> month = count == 1 ? month_of(word) : std::nullopt;
    is_sound = count < fields.size() &&
               (month || (number && is_blank(digits) && *number >= 0.0 && *number <= 9999.0));
    if (is_sound) fields[count++] = month ? *month : static_cast<int>(*number);
  }
  const UtcTime time{fields[0], fields[1], fields[2], fields[3], fields[4], fields[5]};
  if (!is_sound || count < 5 || !is_valid(time)) {
    cursor.fail("a date such as 2018-01-31 21:00(UTC)", fmt::format("\"{}\"", printable(value)),
                "correct the line: there is no such day or hour");
  }
  return iso_time(time).value_or("");
}

double need_value(TextCursor& cursor, std::string_view name, std::string_view value) {
  std::string_view rest = value;
  const std::optional<double> number = take_number(rest);
  if (!number || !is_blank(rest)) {
    cursor.fail(fmt::format("a number after {} =", name), fmt::format("\"{}\"", printable(value)),
                damaged_hint);
  }
  return *number;
}

bool parse_triaxys_type(TextCursor& cursor, std::string_view value) {
  if (value == "DIRECTIONAL SPECTRUM") return true;
  if (value == "NON-DIRECTIONAL SPECTRUM") return false;
  cursor.fail("TYPE = DIRECTIONAL SPECTRUM or NON-DIRECTIONAL SPECTRUM",
              fmt::format("\"{}\"", printable(value)),
              "give the .DIRSPEC or .NONDIRSPEC file of the same time");
}

void parse_triaxys_line(TextCursor& cursor, TriaxysHeader& header) {
  const std::string_view line = cursor.line();
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return;
  const std::string_view name = trimmed(line.substr(0, equals));
  const std::string_view value = trimmed(line.substr(equals + 1));
  if (name == "TYPE") {
    header.is_directional = parse_triaxys_type(cursor, value);
  } else if (name == "DATE") {
    header.time_utc = parse_triaxys_date(cursor, value);
  } else if (name == "NUMBER OF FREQUENCIES") {
    const double count = need_value(cursor, name, value);
    if (count < 2.0 || count > static_cast<double>(cursor.text_size()) / 2.0 || count != std::floor(count)) {
      cursor.fail("a count that fits the size of the file", fmt::format("{:g}", count), damaged_hint);
    }
    header.frequency_count = static_cast<std::size_t>(count);
  } else if (name.starts_with("INITIAL FREQUENCY")) {
    header.first_hz = need_value(cursor, name, value);
  } else if (name.starts_with("FREQUENCY SPACING")) {
    header.step_hz = need_value(cursor, name, value);
  } else if (name.starts_with("DIRECTION SPACING")) {
    header.step_deg = need_value(cursor, name, value);
  }
}

// Ends at the first line of numbers, where the cursor then stands.
TriaxysHeader parse_triaxys_header(TextCursor& cursor) {
  cursor.need_line("TRIAXYS BUOY DATA REPORT");
  TriaxysHeader header;
  // "TRIAXYS BUOY DATA REPORT - TAS01970 - TAB01401 - 4857.6668S16631.6837W"
  if (const std::size_t dash = cursor.line().find(" - "); dash != std::string_view::npos) {
    const std::string_view names = cursor.line().substr(dash + 3);
    header.station = printable(trimmed(names.substr(0, names.find(" - "))));
  }
  for (;;) {
    cursor.need_line("lines of numbers after the header");
    std::string_view rest = cursor.line();
    if (take_number(rest)) break;
    parse_triaxys_line(cursor, header);
  }
  const auto require = [&](bool is_there, std::string_view line) {
    if (!is_there) {
      cursor.fail(fmt::format("a line \"{} = ...\" before the numbers", line), "none", damaged_hint);
    }
  };
  require(header.is_directional.has_value(), "TYPE");
  require(header.frequency_count > 0, "NUMBER OF FREQUENCIES");
  if (*header.is_directional) {
    require(header.first_hz.has_value(), "INITIAL FREQUENCY (Hz)");
    require(header.step_hz.has_value(), "FREQUENCY SPACING (Hz)");
    require(header.step_deg.has_value(), "DIRECTION SPACING (DEG)");
  }
  return header;
}

/// The numbers of the present line.
std::vector<double> numbers_of_line(TextCursor& cursor) {
  std::vector<double> row;
  while (!is_blank(cursor.rest())) row.push_back(cursor.need_number("a number"));
  return row;
}

void require_density(const TextCursor& cursor, double density) {
  if (density < 0.0) cursor.fail("a variance density >= 0", fmt::format("{:g}", density), damaged_hint);
}

void parse_energy(TextCursor& cursor, const TriaxysHeader& header, WaveSpectrum& spectrum) {
  for (std::size_t i = 0; i < header.frequency_count; ++i) {
    if (i > 0) cursor.need_line("a frequency and a density");
    const std::vector<double> row = numbers_of_line(cursor);
    if (row.size() != 2) {
      cursor.fail("a frequency and a density", fmt::format("{} numbers", row.size()), damaged_hint);
    }
    require_density(cursor, row[1]);
    if (row[0] == 0.0) continue;
    spectrum.frequencies_hz.push_back(row[0]);
    spectrum.energy.push_back(row[1]);
  }
  check_frequencies(spectrum.frequencies_hz, cursor.place());
}

// Columns 0 ... 360 degrees in even steps, of which the last repeats the first.
DirectionGrid directions_of(const TextCursor& cursor, std::size_t count, double step_deg) {
  const double turn_deg = step_deg * static_cast<double>(count);
  if (!(step_deg > 0.0 && turn_deg < 360.0 + 1.5 * step_deg)) {
    cursor.fail("columns that cover the circle once",
                fmt::format("{} columns {:g} degrees apart", count, step_deg), damaged_hint);
  }
  std::vector<double> directions_rad;
  for (std::size_t i = 0; i < count; ++i) {
    directions_rad.push_back(direction_from_origin_bearing(static_cast<double>(i) * step_deg * degree_rad));
  }
  return DirectionGrid(std::move(directions_rad), cursor.place());
}

void parse_densities(TextCursor& cursor, const TriaxysHeader& header, WaveSpectrum& spectrum) {
  std::vector<double> density;
  std::optional<DirectionGrid> directions;
  std::size_t count = 0;
  for (std::size_t i = 0; i < header.frequency_count; ++i) {
    if (i > 0) cursor.need_line("a line of densities for each frequency");
    const std::vector<double> row = numbers_of_line(cursor);
    if (!directions) {
      count = row.size();
      directions.emplace(directions_of(cursor, count, *header.step_deg));
    }
    if (row.size() != count) {
      cursor.fail(fmt::format("{} densities", count), std::to_string(row.size()), damaged_hint);
    }
    const double frequency_hz = *header.first_hz + static_cast<double>(i) * *header.step_hz;
    if (frequency_hz == 0.0) continue;
    spectrum.frequencies_hz.push_back(frequency_hz);
    for (const double value : row) {
      require_density(cursor, value);
      density.push_back(value / degree_rad);
    }
  }
  check_frequencies(spectrum.frequencies_hz, cursor.place());
  set_density(spectrum, density, *directions, cursor.place());
}

}  // namespace

std::vector<WaveSpectrum> parse_triaxys(std::string_view text, std::string_view file_name) {
  TextCursor cursor(text, file_name);
  const TriaxysHeader header = parse_triaxys_header(cursor);
  WaveSpectrum spectrum;
  spectrum.station = header.station;
  spectrum.time_utc = header.time_utc;
  if (*header.is_directional) {
    parse_densities(cursor, header, spectrum);
  } else {
    parse_energy(cursor, header, spectrum);
  }
  if (cursor.next_filled_line()) {
    cursor.fail(fmt::format("the end of the file after {} frequencies", header.frequency_count),
                fmt::format("\"{}\"", printable(cursor.line())),
                "correct NUMBER OF FREQUENCIES, or give one file at a time if files were joined");
  }
  return {std::move(spectrum)};
}

}  // namespace offing::spectra
