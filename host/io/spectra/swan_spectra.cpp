#include "host/io/spectra/swan_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/utc_time.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/swan_header.h"

namespace offing::spectra {
namespace {

// ZERO takes five bytes and stands for a spectrum; without this bound on the output a small file could fill
// the memory. A real file needs a line of values or at least its location's line a spectrum.
constexpr std::size_t most_values_a_byte = 100;

int month_number(std::string_view name) {
  constexpr std::array<std::string_view, 12> names{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                   "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
}

// SWAN's time coding options; Y, M, D, h, m, s are digits, N a month's name, the rest stands as it is:
// 1 19870530.153000, 2 30-May-87 15:30:00, 3 05/30/87.15:30:00, 4 15:30:00, 5 87/05/30 15:30:00, 6
// 8705301530.
constexpr std::array<std::string_view, 6> time_forms{"YYYYMMDD.hhmmss",   "DD-NNN-YY hh:mm:ss",
                                                     "MM/DD/YY.hh:mm:ss", "hh:mm:ss",
                                                     "YY/MM/DD hh:mm:ss", "YYMMDDhhmm"};

std::string parse_time(TextCursor& cursor, int coding) {
  const std::string_view form = time_forms[coding - 1];
  std::string_view text = cursor.line();
  text.remove_prefix(text.find_first_not_of(" \t"));
  UtcTime time{0, 0, 0, 0, 0, 0};
  std::string month_name;
  bool is_well_formed = text.size() >= form.size();
  std::size_t year_digits = 0;
  for (std::size_t i = 0; i < form.size() && is_well_formed; ++i) {
    const auto add_digit = [&](int& field) {
      is_well_formed = text[i] >= '0' && text[i] <= '9';
      field = 10 * field + (text[i] - '0');
    };
    switch (form[i]) {
      case 'Y':
        add_digit(time.year);
        ++year_digits;
        break;
      case 'M':
        add_digit(time.month);
        break;
      case 'D':
        add_digit(time.day);
        break;
      case 'h':
        add_digit(time.hour);
        break;
      case 'm':
        add_digit(time.minute);
        break;
      case 's':
        add_digit(time.second);
        break;
      case 'N':
        month_name += text[i];
        break;
      default:
        is_well_formed = text[i] == form[i];
    }
  }
  if (!month_name.empty()) time.month = month_number(month_name);
  // Two-digit years: SWAN and its forerunners began in the 1970s.
  if (year_digits == 2) time.year += time.year >= 70 ? 1900 : 2000;
  if (is_well_formed) {
    // Option 4 has no day.
    if (year_digits == 0) return std::string(text.substr(0, form.size()));
    if (const auto iso = iso_time(time)) return *iso;
  }
  cursor.fail(fmt::format("a time of the form {}", form), fmt::format("\"{}\"", printable(text)),
              "the record before it may have too many or too few lines");
}

std::string_view first_word(const TextCursor& cursor) {
  std::string_view rest = cursor.line();
  return take_word(rest);
}

// The next values of the cursor's line and those after it.
std::vector<double> read_values(TextCursor& cursor, std::size_t count) {
  if (count > cursor.text_size()) {
    cursor.fail("as many values as the header says", fmt::format("a file too short for {}", count),
                "the header is damaged or the file is cut short");
  }
  std::vector<double> values(count);
  for (double& value : values) value = cursor.need_number("a value of the spectrum");
  if (!is_blank(cursor.rest())) {
    cursor.fail("the end of the record", fmt::format("\"{}\"", printable(cursor.rest())),
                "the record has more values than the header says");
  }
  return values;
}

// Leaves out the frequencies whose flag is set.
template <typename Row>
void erase_rows(std::vector<Row>& rows, const std::vector<char>& is_missing, std::size_t width) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!is_missing[i / width]) rows[kept++] = rows[i];
  }
  rows.resize(kept);
}

// Stands on FACTOR. Empty frequencies: nothing but exception values.
void read_2d(TextCursor& cursor, const SwanHeader& header, WaveSpectrum& spectrum) {
  cursor.need_line("the factor");
  const double factor = cursor.need_number("the factor");
  const SwanQuantity& quantity = header.quantities.front();
  const std::size_t nd = header.file_direction_count;
  const std::string where = cursor.place();
  std::vector<double> density = read_values(cursor, header.frequencies_hz.size() * nd);
  std::vector<char> is_missing(header.frequencies_hz.size(), 0);
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (density[i] == quantity.exception_value) is_missing[i / nd] = 1;
    density[i] *= factor * quantity.unit;
  }
  spectrum.frequencies_hz = header.frequencies_hz;
  erase_rows(spectrum.frequencies_hz, is_missing, 1);
  erase_rows(density, is_missing, nd);
  if (!spectrum.frequencies_hz.empty()) set_density(spectrum, density, *header.directions, where);
}

// Stands on the line before the table.
void read_1d(TextCursor& cursor, const SwanHeader& header, WaveSpectrum& spectrum) {
  const std::string where = cursor.place();
  const std::size_t width = header.quantities.size();
  const std::vector<double> table = read_values(cursor, header.frequencies_hz.size() * width);
  std::vector<ReportedMoments> moments;
  for (std::size_t i = 0; i < header.frequencies_hz.size(); ++i) {
    std::optional<double> density;
    std::optional<double> direction_rad;
    std::optional<double> spread_rad;
    for (std::size_t column = 0; column < width; ++column) {
      const SwanQuantity& quantity = header.quantities[column];
      const double value = table[i * width + column];
      if (value == quantity.exception_value) continue;
      if (quantity.kind == SwanQuantity::Kind::density) density = value * quantity.unit;
      if (quantity.kind == SwanQuantity::Kind::direction) {
        direction_rad = swan_direction_rad(value, quantity.convention);
      }
      if (quantity.kind == SwanQuantity::Kind::spread) spread_rad = value * degree_rad;
    }
    if (!density) continue;
    spectrum.frequencies_hz.push_back(header.frequencies_hz[i]);
    spectrum.energy.push_back(*density);
    ReportedMoments& reported = moments.emplace_back();
    if (direction_rad && spread_rad && std::isfinite(*direction_rad)) {
      const double r1 = std::max(0.0, 1.0 - 0.5 * *spread_rad * *spread_rad);
      reported.kind = ReportedMoments::Kind::first;
      reported.moments.first = std::polar(r1, *direction_rad);
    }
  }
  check_densities(spectrum.energy, where);
  set_moments(spectrum, moments);
}

// Reads what follows for one location; nothing if it holds no data. Stands on the record's keyword, or in
// stationary one-dimensional files on the line before the table.
std::optional<WaveSpectrum> parse_record(TextCursor& cursor, const SwanHeader& header,
                                         const SwanLocation& location) {
  cursor.need_line("FACTOR, ZERO, NODATA or LOCATION");
  const std::string_view keyword = first_word(cursor);
  if (keyword == "NODATA") return std::nullopt;
  WaveSpectrum spectrum{
      location.station, {}, location.latitude_deg, location.longitude_deg, {}, {}, {}, {}, {}};
  if (keyword == "ZERO") {
    spectrum.frequencies_hz = header.frequencies_hz;
    spectrum.energy.assign(spectrum.frequencies_hz.size(), 0.0);
    return spectrum;
  }
  if (keyword != (header.directions ? "FACTOR" : "LOCATION")) {
    cursor.fail(header.directions ? "FACTOR, ZERO or NODATA" : "LOCATION, ZERO or NODATA",
                fmt::format("\"{}\"", printable(cursor.line())),
                "the record before it may have too many or too few lines");
  }
  if (header.directions) {
    read_2d(cursor, header, spectrum);
  } else {
    cursor.need_line("a table of values");
    read_1d(cursor, header, spectrum);
  }
  if (spectrum.frequencies_hz.size() < 2) return std::nullopt;
  return spectrum;
}

}  // namespace

std::vector<WaveSpectrum> parse_swan(std::string_view text, std::string_view file_name) {
  TextCursor cursor(text, file_name);
  const SwanHeader header = parse_swan_header(cursor);
  const std::size_t budget = 100'000 + most_values_a_byte * text.size();
  std::size_t values = 0;
  std::vector<WaveSpectrum> spectra;
  const auto read_all_locations = [&](const std::string& time_utc) {
    for (const SwanLocation& location : header.locations) {
      std::optional<WaveSpectrum> spectrum = parse_record(cursor, header, location);
      if (!spectrum) continue;
      spectrum->time_utc = time_utc;
      values +=
          spectrum->frequencies_hz.size() * 2 + spectrum->spreading.size() + spectrum->directions_rad.size();
      if (values > budget) {
        cursor.fail("as many spectra as the file's size can hold", "more", "the header is damaged");
      }
      spectra.push_back(std::move(*spectrum));
    }
  };
  if (header.time_coding == 0) {
    read_all_locations("");
    if (cursor.next_filled_line()) {
      cursor.fail("the end of the file", fmt::format("\"{}\"", printable(cursor.line())),
                  "without TIME in the header there is one record a location");
    }
  } else {
    cursor.need_line("a time");
    do {
      read_all_locations(parse_time(cursor, header.time_coding));
    } while (cursor.next_filled_line());
  }
  if (spectra.empty()) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected at least one location with data, got none", printable_name(file_name)),
        "every location is marked NODATA; choose points at sea");
  }
  return spectra;
}

}  // namespace offing::spectra
