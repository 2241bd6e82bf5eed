#include "host/io/spectra/spotter_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/base/utc_time.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/gzip.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

using nlohmann::json;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A record as the buoy reports it: a value for each frequency, NaN where it is missing, or no values.
struct Record {
  std::string time_utc;
  double latitude_deg = missing, longitude_deg = missing;
  std::vector<double> frequency_hz, density;
  std::vector<double> a1, b1, a2, b2;
  std::vector<double> direction_deg, spread_deg;
};

/// The lists of a record, as both forms of the file name them.
struct List {
  const char* json_key;
  const char* csv_prefix;  ///< of the columns prefix0, prefix1, ...
  std::vector<double> Record::*values;
};
constexpr std::array<List, 8> lists{{{"frequency", "f_", &Record::frequency_hz},
                                     {"varianceDensity", "varianceDensity_", &Record::density},
                                     {"a1", "a1_", &Record::a1},
                                     {"b1", "b1_", &Record::b1},
                                     {"a2", "a2_", &Record::a2},
                                     {"b2", "b2_", &Record::b2},
                                     {"direction", "direction_", &Record::direction_deg},
                                     {"directionalSpread", "directionalSpread_", &Record::spread_deg}}};
constexpr std::size_t required_lists = 2;

[[noreturn]] void fail_at(std::string_view place, std::string_view expected, std::string_view got) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: expected {}, got {}", place, expected, got),
              damaged_hint);
}

/// Counterclockwise from east, as the buoy has it, to clockwise, as WaveSpectrum has it.
std::complex<double> moment_of(double cosine, double sine) {
  return {cosine, -sine};
}

ReportedMoments moments_of(const Record& record, std::size_t i, std::string_view place) {
  const auto value = [i](const std::vector<double>& values) {
    return i < values.size() ? values[i] : missing;
  };
  for (const List& list : lists) {
    const bool is_moment = list.values == &Record::a1 || list.values == &Record::b1 ||
                           list.values == &Record::a2 || list.values == &Record::b2;
    const double found = value(record.*list.values);
    if (is_moment && std::abs(found) > 1.0) {
      fail_at(place, fmt::format("{} within [-1, 1]", list.json_key), fmt::format("{:g}", found));
    }
  }
  const auto first = moment_of(value(record.a1), value(record.b1));
  const auto second = moment_of(value(record.a2), value(record.b2));
  const auto is_known = [](std::complex<double> m) { return !std::isnan(m.real()) && !std::isnan(m.imag()); };
  if (is_known(first) && is_known(second)) return {ReportedMoments::Kind::both, {first, second}};
  if (is_known(first)) return {ReportedMoments::Kind::first, {first, {}}};
  const double direction_deg = value(record.direction_deg);
  const double spread_deg = value(record.spread_deg);
  if (std::isnan(direction_deg) || std::isnan(spread_deg)) return {};
  if (std::abs(direction_deg) > 360.0 || spread_deg < 0.0 || spread_deg > 180.0) {
    fail_at(place, "a direction within 360 degrees and a spread within [0, 180]",
            fmt::format("{:g} and {:g}", direction_deg, spread_deg));
  }
  const double spread_rad = spread_deg * degree_rad;
  const double r1 = std::max(0.0, 1.0 - 0.5 * spread_rad * spread_rad);
  return {ReportedMoments::Kind::first,
          {std::polar(r1, direction_from_origin_bearing(direction_deg * degree_rad)), {}}};
}

/// Nothing for a record with fewer than two densities.
std::optional<WaveSpectrum> spectrum_of(const Record& record, std::string_view place) {
  for (const List& list : lists) {
    const std::vector<double>& values = record.*list.values;
    const bool is_needed = &list < &lists[required_lists];
    if (values.size() == record.frequency_hz.size() || (values.empty() && !is_needed)) continue;
    fail_at(place, fmt::format("{} values of {}", record.frequency_hz.size(), list.json_key),
            std::to_string(values.size()));
  }
  WaveSpectrum spectrum;
  std::vector<ReportedMoments> moments;
  for (std::size_t i = 0; i < record.frequency_hz.size(); ++i) {
    if (std::isnan(record.frequency_hz[i]) || std::isnan(record.density[i])) continue;
    spectrum.frequencies_hz.push_back(record.frequency_hz[i]);
    spectrum.energy.push_back(record.density[i]);
    moments.push_back(moments_of(record, i, place));
  }
  if (spectrum.frequencies_hz.size() < 2) return std::nullopt;
  check_frequencies(spectrum.frequencies_hz, place);
  check_densities(spectrum.energy, place);
  set_moments(spectrum, moments);
  spectrum.time_utc = record.time_utc;
  if (std::abs(record.latitude_deg) <= 90.0 && std::isfinite(record.longitude_deg)) {
    spectrum.latitude_deg = record.latitude_deg;
    spectrum.longitude_deg = record.longitude_deg;
  }
  return spectrum;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (!line.empty()) cells.push_back(take_cell(line));
  return cells;
}

/// The columns of the CSV that hold what a record needs.
class CsvColumns {
 public:
  explicit CsvColumns(TextCursor& cursor) {
    std::map<std::string_view, std::size_t> places;
    const std::vector<std::string_view> cells = cells_of(cursor.line());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      // "Latitude (deg)"
      places.emplace(trimmed(cells[i].substr(0, cells[i].find('('))), i);
    }
    count_ = cells.size();
    const auto place_of = [&](std::string_view name) {
      const auto found = places.find(name);
      return found == places.end() ? std::nullopt : std::optional(found->second);
    };
    time_ = place_of("Epoch Time");
    latitude_ = place_of("Latitude");
    longitude_ = place_of("Longitude");
    for (std::size_t i = 0; i < lists.size(); ++i) {
      const auto next = [&] { return place_of(fmt::format("{}{}", lists[i].csv_prefix, lists_[i].size())); };
      for (auto place = next(); place; place = next()) lists_[i].push_back(*place);
    }
    if (!time_) {
      cursor.fail("a column Epoch Time", "none",
                  "give the CSV of the Spotter dashboard with wave spectra, unchanged");
    }
  }

  Record read(TextCursor& cursor) const {
    const std::vector<std::string_view> cells = cells_of(cursor.line());
    if (cells.size() < count_) {
      cursor.fail(fmt::format("{} columns", count_), std::to_string(cells.size()),
                  "the line is cut short or was edited: get the file again");
    }
    Record record;
    record.time_utc = time_of(cursor, number(cursor, cells[*time_]));
    if (latitude_ && longitude_) {
      record.latitude_deg = number(cursor, cells[*latitude_]);
      record.longitude_deg = number(cursor, cells[*longitude_]);
    }
    for (std::size_t i = 0; i < lists.size(); ++i) {
      for (const std::size_t place : lists_[i]) {
        (record.*lists[i].values).push_back(number(cursor, cells[place]));
      }
    }
    return record;
  }

 private:
  static double number(const TextCursor& cursor, std::string_view cell) {
    if (cell.empty() || cell == "-" || cell == "nan" || cell == "NaN") return missing;
    std::string_view rest = cell;
    const std::optional<double> value = take_number(rest);
    if (!value || !is_blank(rest)) {
      cursor.fail("a number, or - where it is missing", fmt::format("\"{}\"", printable(cell)), damaged_hint);
    }
    return *value;
  }

  static std::string time_of(const TextCursor& cursor, double unix_time) {
    // To the end of the year 9999.
    if (!(unix_time >= 0.0 && unix_time <= 253402300799.0)) {
      cursor.fail("a time in seconds since 1970", fmt::format("{:g}", unix_time), damaged_hint);
    }
    return iso_time(from_unix_seconds(static_cast<std::int64_t>(unix_time))).value_or("");
  }

  std::size_t count_ = 0;
  std::optional<std::size_t> time_, latitude_, longitude_;
  std::array<std::vector<std::size_t>, lists.size()> lists_;
};

std::vector<WaveSpectrum> parse_csv(std::string_view text, std::string_view file_name) {
  TextCursor cursor(text, file_name);
  cursor.need_line("a line of column names");
  const CsvColumns columns(cursor);
  const std::string station = unpacked_name(std::string(file_name)).stem().string();
  std::vector<WaveSpectrum> spectra;
  while (cursor.next_filled_line()) {
    std::optional<WaveSpectrum> spectrum = spectrum_of(columns.read(cursor), cursor.place());
    if (!spectrum) continue;
    spectrum->station = station;
    spectra.push_back(std::move(*spectrum));
  }
  return spectra;
}

json parse_text(std::string_view text, std::string_view file_name) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const std::string_view before = text.substr(0, std::min(error.byte, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    fail_at(fmt::format("{}:{}", printable_name(file_name), line), "JSON",
            fmt::format("a fault after {} bytes", error.byte));
  } catch (const json::exception&) {  // such as 1e999
    fail_at(printable_name(file_name), "JSON with finite numbers", "others");
  }
}

const json* member(const json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? &*found : nullptr;
}

double json_number(const json& value, std::string_view place) {
  if (value.is_null()) return missing;
  if (!value.is_number()) fail_at(place, "numbers, or null where one is missing", value.type_name());
  return value.get<double>();
}

Record json_record(const json& object, const std::string& place) {
  Record record;
  if (const json* time = member(object, "timestamp"); time && time->is_string()) {
    // "2018-02-14T00:27:19.000Z"
    const auto text = time->get<std::string>();
    const auto moment =
        parse_iso_time(text.substr(0, text.find('.')) + (text.find('.') == text.npos ? "" : "Z"));
    if (!moment) {
      fail_at(place + ".timestamp", "a time such as 2018-02-14T00:27:19.000Z",
              fmt::format("\"{}\"", printable(text)));
    }
    record.time_utc = iso_time(*moment).value_or("");
  }
  const json* latitude = member(object, "latitude");
  const json* longitude = member(object, "longitude");
  if (latitude && longitude) {
    record.latitude_deg = json_number(*latitude, place + ".latitude");
    record.longitude_deg = json_number(*longitude, place + ".longitude");
  }
  for (const List& list : lists) {
    const json* values = member(object, list.json_key);
    if (!values) continue;
    const std::string where = fmt::format("{}.{}", place, list.json_key);
    if (!values->is_array()) fail_at(where, "a list of numbers", values->type_name());
    for (const json& value : *values) (record.*list.values).push_back(json_number(value, where));
  }
  return record;
}

std::vector<WaveSpectrum> parse_json(std::string_view text, std::string_view file_name) {
  const json root = parse_text(text, file_name);
  const json* data = member(root, "data");
  const json* records = data ? member(*data, "frequencyData") : nullptr;
  if (!records || !records->is_array()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a list data.frequencyData, got none", printable_name(file_name)),
                "ask the interface for the data with includeFrequencyData=true");
  }
  const json* station = member(*data, "spotterId");
  std::vector<WaveSpectrum> spectra;
  for (std::size_t i = 0; i < records->size(); ++i) {
    const std::string place = fmt::format("{}: data.frequencyData[{}]", printable_name(file_name), i);
    std::optional<WaveSpectrum> spectrum = spectrum_of(json_record((*records)[i], place), place);
    if (!spectrum) continue;
    if (station && station->is_string()) spectrum->station = printable(station->get<std::string>());
    spectra.push_back(std::move(*spectrum));
  }
  return spectra;
}

bool is_json(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{';
}

}  // namespace

bool is_spotter(std::string_view first_filled_line) {
  return is_json(first_filled_line) || (first_filled_line.find("Epoch Time") != std::string_view::npos &&
                                        first_filled_line.find("varianceDensity_") != std::string_view::npos);
}

std::vector<WaveSpectrum> parse_spotter(std::string_view text, std::string_view file_name) {
  std::vector<WaveSpectrum> spectra =
      is_json(text) ? parse_json(text, file_name) : parse_csv(text, file_name);
  if (spectra.empty()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected at least one record with two densities, got none",
                            printable_name(file_name)),
                "choose a time at which the buoy sent spectra");
  }
  return spectra;
}

}  // namespace offing::spectra
