#include "host/io/spectra/ww3_spectra.h"

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

// Takes a Fortran character constant 'like ''this''' off `rest`.
std::optional<std::string> take_quoted(std::string_view& rest) {
  std::size_t at = rest.find_first_not_of(" \t");
  if (at == std::string_view::npos || rest[at] != '\'') return std::nullopt;
  std::string text;
  for (++at; at < rest.size(); ++at) {
    if (rest[at] != '\'') {
      text += rest[at];
    } else if (at + 1 < rest.size() && rest[at + 1] == '\'') {
      text += rest[++at];
    } else {
      rest = rest.substr(at + 1);
      const std::size_t end = text.find_last_not_of(' ');
      text.resize(end == std::string::npos ? 0 : end + 1);
      return text;
    }
  }
  return std::nullopt;
}

std::string need_quoted(TextCursor& cursor, std::string_view expected) {
  while (is_blank(cursor.rest())) cursor.need_line(expected);
  std::optional<std::string> text = take_quoted(cursor.rest());
  if (!text) {
    cursor.fail(expected, fmt::format("\"{}\"", printable(cursor.rest())),
                "names stand in single quotes in WAVEWATCH III files");
  }
  return *text;
}

struct Grid {
  std::vector<double> frequencies_hz;
  DirectionGrid directions;
  std::size_t direction_count;
  std::size_t point_count;
};

Grid parse_grid(TextCursor& cursor) {
  const std::string title = need_quoted(cursor, "'WAVEWATCH III SPECTRA'");
  if (title.find("WAVEWATCH III SPECTRA") == std::string::npos) {
    cursor.fail("'WAVEWATCH III SPECTRA'", fmt::format("'{}'", printable(title)),
                "give the spectral transfer file of ww3_outp (ITYPE 1, transfer file)");
  }
  const std::size_t nf = cursor.need_count("the number of frequencies");
  const std::size_t nd = cursor.need_count("the number of directions");
  const std::size_t points = cursor.need_count("the number of points");
  if (static_cast<double>(nf) * static_cast<double>(nd) > static_cast<double>(cursor.text_size()) / 2.0) {
    cursor.fail("counts that fit the size of the file", fmt::format("{} x {} densities", nf, nd),
                "the header is damaged or the file is cut short: write it again");
  }
  need_quoted(cursor, "the name of the grid in quotes");
  std::vector<double> frequencies_hz(nf);
  for (double& f_hz : frequencies_hz) f_hz = cursor.need_number("a frequency in Hz");
  std::vector<double> directions_rad(nd);
  for (double& angle : directions_rad) {
    angle = direction_from_travel_bearing(cursor.need_number("a direction in rad"));
  }
  const std::string where = cursor.place();
  check_frequencies(frequencies_hz, where);
  return {std::move(frequencies_hz), DirectionGrid(std::move(directions_rad), where), nd, points};
}

// "20220912 060000"
std::string parse_time(TextCursor& cursor) {
  const double date = cursor.need_number("a date and time such as 20220912 060000");
  const double clock = cursor.need_number("a time such as 060000");
  const bool is_whole = date == std::floor(date) && clock == std::floor(clock);
  if (is_whole && date >= 0.0 && date <= 99991231.0 && clock >= 0.0 && clock <= 240000.0) {
    const int day = static_cast<int>(date);
    const int second = static_cast<int>(clock);
    const UtcTime time{day / 10000,    day / 100 % 100,    day % 100,
                       second / 10000, second / 100 % 100, second % 100};
    if (const auto text = iso_time(time)) return time.year == 1 ? std::string() : *text;
  }
  cursor.fail("a date and time such as 20220912 060000", fmt::format("{:.0f} {:.0f}", date, clock),
              "correct the date, or the number of values in the record before it");
}

WaveSpectrum parse_point(TextCursor& cursor, const Grid& grid) {
  WaveSpectrum spectrum;
  spectrum.station = need_quoted(cursor, "the name of a point in quotes");
  const double latitude_deg = cursor.need_number("a latitude in degrees");
  const double longitude_deg = cursor.need_number("a longitude in degrees");
  const double depth_m = cursor.need_number("a depth in m");
  for (const char* skipped :
       {"a wind speed in m/s", "a wind direction", "a current in m/s", "a current direction"}) {
    cursor.need_number(skipped);
  }
  if (std::abs(latitude_deg) <= 90.0) {
    spectrum.latitude_deg = latitude_deg;
    spectrum.longitude_deg = longitude_deg;
  }
  if (depth_m > 0.0) spectrum.depth_m = depth_m;

  spectrum.frequencies_hz = grid.frequencies_hz;
  const std::size_t nf = grid.frequencies_hz.size();
  std::vector<double> density(nf * grid.direction_count);
  const std::string where = cursor.place();
  for (std::size_t direction = 0; direction < grid.direction_count; ++direction) {
    for (std::size_t i = 0; i < nf; ++i) {
      density[i * grid.direction_count + direction] = cursor.need_number("a density in m^2/Hz/rad");
    }
  }
  set_density(spectrum, density, grid.directions, where);
  return spectrum;
}

}  // namespace

std::vector<WaveSpectrum> parse_ww3(std::string_view text, std::string_view file_name) {
  TextCursor cursor(text, file_name);
  const Grid grid = parse_grid(cursor);
  std::vector<WaveSpectrum> spectra;
  do {
    const std::string time_utc = parse_time(cursor);
    for (std::size_t point = 0; point < grid.point_count; ++point) {
      WaveSpectrum spectrum = parse_point(cursor, grid);
      spectrum.time_utc = time_utc;
      spectra.push_back(std::move(spectrum));
    }
    if (!is_blank(cursor.rest())) {
      cursor.fail("a new line after the last density", fmt::format("\"{}\"", printable(cursor.rest())),
                  "the record has more values than the header says: write the file again");
    }
  } while (cursor.next_filled_line());
  return spectra;
}

}  // namespace offing::spectra
