#include "host/io/spectra/datawell_spectra.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <complex>
#include <filesystem>
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

constexpr int header_line_count = 12;
constexpr int largest_density_line = 4;

struct Row {
  double frequency_hz;
  double relative_density;
  ReportedMoments moments;
};

DirectionalMoments moments_of(double direction_deg, double spread_deg, double skewness, double kurtosis) {
  const double spread_rad = spread_deg * degree_rad;
  const double variance = spread_rad * spread_rad;
  const double m1 = std::max(0.0, 1.0 - 0.5 * variance);
  // Noise can put m2 outside its range; beyond it n2 has no meaning either.
  const double m2 = std::clamp(0.5 * (kurtosis * variance * variance - 6.0 + 8.0 * m1), -1.0, 1.0);
  const double n2 = -skewness * std::pow(0.5 * (1.0 - m2), 1.5);
  const double mean_rad = direction_from_origin_bearing(direction_deg * degree_rad);
  return {std::polar(m1, mean_rad), std::complex<double>(m2, n2) * std::polar(1.0, 2.0 * mean_rad)};
}

Row parse_row(TextCursor& cursor) {
  double values[6] = {};
  int count = 0;
  while (!is_blank(cursor.rest()) && count < 6) {
    values[count++] = cursor.need_number("f, S/Smax, direction, spread, skewness, kurtosis");
  }
  if ((count != 2 && count != 6) || !is_blank(cursor.rest())) {
    cursor.fail("six values: f, S/Smax, direction, spread, skewness, kurtosis",
                fmt::format("\"{}\"", printable(cursor.line())),
                "the line is cut short or was edited: get the file again");
  }
  Row row{values[0], values[1], {}};
  if (row.relative_density < 0.0) {
    cursor.fail("a density S/Smax >= 0", fmt::format("{:g}", row.relative_density),
                "the file is damaged: get it again");
  }
  if (count == 6) {
    if (std::abs(values[2]) > 360.0 || values[3] < 0.0 || values[3] > 180.0) {
      cursor.fail("a direction within 360 degrees and a spread within [0, 180]",
                  fmt::format("{:g} and {:g}", values[2], values[3]), "the file is damaged: get it again");
    }
    row.moments = {ReportedMoments::Kind::both, moments_of(values[2], values[3], values[4], values[5])};
  }
  return row;
}

// The time in "...2024-09-09T01h15Z", wherever it ends in the stem.
std::optional<UtcTime> time_in_name(std::string_view stem) {
  constexpr std::string_view form = "dddd-dd-ddTddhdd";
  for (std::size_t begin = 0; begin + form.size() <= stem.size(); ++begin) {
    std::string text(stem.substr(begin, form.size()));
    if (text[13] != 'h') continue;
    text[13] = ':';
    if (const auto time = parse_iso_time(text + "Z")) return time;
  }
  return std::nullopt;
}

}  // namespace

std::vector<WaveSpectrum> parse_datawell(std::string_view text, std::string_view file_name) {
  WaveSpectrum spectrum;
  const std::string stem = std::filesystem::path(std::string(file_name)).stem().string();
  if (const auto time = time_in_name(stem)) spectrum.time_utc = iso_time(*time).value_or("");
  spectrum.station = stem.substr(0, stem.find('}'));

  TextCursor cursor(text, file_name);
  double largest_density = 0.0;
  for (int i = 1; i <= header_line_count; ++i) {
    cursor.need_line("twelve header lines of one value");
    const double value = cursor.need_number("a header line of one value");
    if (!is_blank(cursor.rest())) {
      cursor.fail("a header line of one value", fmt::format("\"{}\"", printable(cursor.line())),
                  "a Datawell .spt file starts with twelve lines of one value each");
    }
    if (i != largest_density_line) continue;
    largest_density = value;
    if (largest_density < 0.0) {
      cursor.fail("the largest density in m^2/Hz", fmt::format("{:g}", value),
                  "the file is damaged: get it again");
    }
  }
  std::vector<ReportedMoments> moments;
  while (cursor.next_filled_line()) {
    const Row row = parse_row(cursor);
    spectrum.frequencies_hz.push_back(row.frequency_hz);
    spectrum.energy.push_back(row.relative_density * largest_density);
    moments.push_back(row.moments);
    if (!std::isfinite(spectrum.energy.back())) {
      cursor.fail("a density S/Smax of at most 1", fmt::format("{:g}", row.relative_density),
                  "the file is damaged: get it again");
    }
  }
  check_frequencies(spectrum.frequencies_hz, printable_name(file_name));
  set_moments(spectrum, moments);
  return {std::move(spectrum)};
}

}  // namespace offing::spectra
