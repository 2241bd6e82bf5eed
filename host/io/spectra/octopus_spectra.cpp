#include "host/io/spectra/octopus_spectra.h"

#include <algorithm>
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

/// Moves to a line whose first cell is `label`, and past that cell.
void need_labelled_line(TextCursor& cursor, std::string_view label) {
  const std::string expected = fmt::format("a line that begins with {}", label);
  cursor.need_line(expected);
  const std::string_view cell = take_cell(cursor.rest());
  if (cell != label) cursor.fail(expected, fmt::format("\"{}\"", printable(cell)), damaged_hint);
}

/// The next number of the present line.
double need_number_here(TextCursor& cursor, std::string_view expected) {
  if (is_blank(cursor.rest())) cursor.fail(expected, "the end of the line", damaged_hint);
  return cursor.need_number(expected);
}

std::size_t need_labelled_count(TextCursor& cursor, std::string_view label) {
  need_labelled_line(cursor, label);
  return cursor.need_count(fmt::format("a count after {},", label));
}

double need_labelled_number(TextCursor& cursor, std::string_view label) {
  need_labelled_line(cursor, label);
  return need_number_here(cursor, fmt::format("a number after {},", label));
}

struct Site {
  std::size_t frequency_count, direction_count, record_count;
  double latitude_deg, longitude_deg, depth_m;
};

Site parse_site(TextCursor& cursor) {
  Site site{};
  site.frequency_count = need_labelled_count(cursor, "nfreqs");
  site.direction_count = need_labelled_count(cursor, "ndir");
  site.record_count = need_labelled_count(cursor, "nrecs");
  const double values = static_cast<double>(site.frequency_count) *
                        static_cast<double>(site.direction_count) * static_cast<double>(site.record_count);
  if (values > static_cast<double>(cursor.text_size()) / 2.0) {
    cursor.fail("counts that fit the size of the file", fmt::format("{:g} values", values), damaged_hint);
  }
  site.latitude_deg = need_labelled_number(cursor, "Latitude");
  site.longitude_deg = need_labelled_number(cursor, "Longitude");
  site.depth_m = need_labelled_number(cursor, "Depth");
  return site;
}

// CCYYMM and DDHHmm, "201803" and "'110000".
std::string time_of(TextCursor& cursor, std::string_view month, std::string_view minute) {
  if (minute.starts_with('\'')) minute.remove_prefix(1);
  const auto is_digits = [](std::string_view text) {
    return text.size() == 6 && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (is_digits(month) && is_digits(minute)) {
    const auto whole = [](std::string_view text) { return std::stoi(std::string(text)); };
    const UtcTime time{whole(month.substr(0, 4)),  whole(month.substr(4)),     whole(minute.substr(0, 2)),
                       whole(minute.substr(2, 2)), whole(minute.substr(4, 2)), 0};
    if (is_valid(time)) return iso_time(time).value_or("");
  }
  cursor.fail("a time such as 201803,'110000", fmt::format("\"{},{}\"", printable(month), printable(minute)),
              "the first cells are year and month, then day, hour and minute");
}

/// The width of each frequency in a trapezoidal sum, Hz.
std::vector<double> widths_hz(const std::vector<double>& frequencies_hz) {
  std::vector<double> widths(frequencies_hz.size(), 0.0);
  for (std::size_t i = 1; i < frequencies_hz.size(); ++i) {
    const double half_hz = 0.5 * (frequencies_hz[i] - frequencies_hz[i - 1]);
    widths[i - 1] += half_hz;
    widths[i] += half_hz;
  }
  return widths;
}

/// Fills in frequencies and densities; false if a value is missing.
bool parse_variances(TextCursor& cursor, const Site& site, WaveSpectrum& spectrum) {
  const std::size_t nf = site.frequency_count, nd = site.direction_count;
  need_labelled_line(cursor, "freq");
  for (std::size_t i = 0; i < nf; ++i) {
    spectrum.frequencies_hz.push_back(need_number_here(cursor, "a frequency in Hz"));
  }
  check_frequencies(spectrum.frequencies_hz, cursor.place());

  std::vector<double> directions_rad;
  std::vector<double> variance(nf * nd);
  bool is_missing = false;
  for (std::size_t direction = 0; direction < nd; ++direction) {
    cursor.need_line("a line for each direction");
    const double bearing_deg = need_number_here(cursor, "a bearing in degrees");
    directions_rad.push_back(direction_from_origin_bearing(bearing_deg * degree_rad));
    for (std::size_t i = 0; i < nf; ++i) {
      const double value = need_number_here(cursor, "a variance in m^2");
      variance[i * nd + direction] = value;
      is_missing |= value < 0.0;
    }
  }
  const std::string where = cursor.place();
  const DirectionGrid grid(std::move(directions_rad), where);
  if (grid.directions_rad().size() != nd) {
    cursor.fail(fmt::format("{} bearings evenly spaced over the circle", nd), "others", damaged_hint);
  }
  if (is_missing) return false;
  set_density(spectrum, variance, grid, where);
  const std::vector<double> widths = widths_hz(spectrum.frequencies_hz);
  for (std::size_t i = 0; i < nf; ++i) {
    double sum_m2 = 0.0;
    for (std::size_t direction = 0; direction < nd; ++direction) sum_m2 += variance[i * nd + direction];
    // Where set_density() found too little to spread there are no waves.
    if (spectrum.energy[i] > 0.0) spectrum.energy[i] = sum_m2 / widths[i];
  }
  check_densities(spectrum.energy, where);
  return true;
}

/// Nothing for a record with missing values.
std::optional<WaveSpectrum> parse_record(TextCursor& cursor, const Site& site) {
  need_labelled_line(cursor, "CCYYMM");
  cursor.need_line("the values of a record");
  const std::string_view month = take_cell(cursor.rest());
  const std::string_view minute = take_cell(cursor.rest());
  const std::string_view point = take_cell(cursor.rest());
  WaveSpectrum spectrum;
  spectrum.time_utc = time_of(cursor, month, minute);
  // "maari_20180311_00z"
  spectrum.station = printable(point.substr(0, point.find(fmt::format("_{}", month))));
  if (std::abs(site.latitude_deg) <= 90.0) {
    spectrum.latitude_deg = site.latitude_deg;
    spectrum.longitude_deg = site.longitude_deg;
  }
  if (site.depth_m > 0.0) spectrum.depth_m = site.depth_m;
  const bool is_whole = parse_variances(cursor, site, spectrum);
  // Sums over directions, which the variances have too.
  need_labelled_line(cursor, "fSpec");
  need_labelled_line(cursor, "den");
  return is_whole ? std::optional(std::move(spectrum)) : std::nullopt;
}

}  // namespace

std::vector<WaveSpectrum> parse_octopus(std::string_view text, std::string_view file_name) {
  TextCursor cursor(text, file_name);
  std::vector<WaveSpectrum> spectra;
  cursor.need_line("Forecast valid for ...");
  do {
    if (!cursor.line().starts_with("Forecast valid for")) {
      cursor.fail("Forecast valid for ... or the end of the file",
                  fmt::format("\"{}\"", printable(cursor.line())), "nrecs is wrong, or the file is damaged");
    }
    const Site site = parse_site(cursor);
    for (std::size_t i = 0; i < site.record_count; ++i) {
      if (auto spectrum = parse_record(cursor, site)) spectra.push_back(std::move(*spectrum));
    }
  } while (cursor.next_filled_line());
  if (spectra.empty()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected at least one record without missing values, got none",
                            printable_name(file_name)),
                "choose times and points at sea");
  }
  return spectra;
}

}  // namespace offing::spectra
