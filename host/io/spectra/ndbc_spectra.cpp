#include "host/io/spectra/ndbc_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/utc_time.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/gzip.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

/// What the columns of an NDBC spectral text file hold. Historical files do not say: their name does.
enum class NdbcQuantity { unstated, energy, alpha1, alpha2, r1, r2 };

/// One value at one frequency; no value if the file has its mark for missing data.
struct NdbcSample {
  double frequency_hz;
  std::optional<double> value;
};

struct NdbcRow {
  UtcTime time;
  std::size_t line_number;
  std::vector<NdbcSample> samples;  ///< frequencies strictly increasing
};

/// An NDBC spectral text file as it stands: realtime ("value (frequency)" pairs, .data_spec, .swdir ...) or
/// historical (frequencies in the header; with or without minutes, years of two or four digits).
struct NdbcTable {
  NdbcQuantity quantity = NdbcQuantity::unstated;
  std::vector<NdbcRow> rows;  ///< in file order
};

// NDBC fills missing spectral values with 999; older historical files with 99. No density, percentage or
// bearing reaches 999.
constexpr double missing_from = 999.0;
constexpr double old_missing = 99.0;

struct Header {
  NdbcQuantity quantity = NdbcQuantity::unstated;
  int date_columns = 0;
  bool has_separation_frequency = false;
  std::vector<double> frequencies_hz;  ///< empty in realtime files

  bool is_historical() const { return !frequencies_hz.empty(); }
};

// "#YY MM DD hh mm" and its older relatives; true if `line` starts with such names of date columns.
bool is_header(std::string_view line) {
  const std::string_view word = take_word(line);
  return word.starts_with('#') || word == "YY" || word == "YYYY";
}

NdbcQuantity stated_quantity(TextCursor& cursor) {
  const std::string_view line = cursor.line();
  const auto mentions = [&](std::string_view name) { return line.find(name) != std::string_view::npos; };
  if (mentions("spec_1")) return NdbcQuantity::energy;
  if (mentions("alpha1_1")) return NdbcQuantity::alpha1;
  if (mentions("alpha2_1")) return NdbcQuantity::alpha2;
  if (mentions("r1_1")) return NdbcQuantity::r1;
  if (mentions("r2_1")) return NdbcQuantity::r2;
  if (mentions("WVHT")) {
    cursor.fail("columns of spectral densities", "columns of wave heights and periods",
                "this is a summary without spectra; give the .data_spec file of the same station");
  }
  cursor.fail("names of spectral columns or a list of frequencies", fmt::format("\"{}\"", printable(line)),
              "an NDBC spectral file starts with a line such as #YY MM DD hh mm .0200 .0325");
}

Header parse_header(TextCursor& cursor) {
  Header header;
  std::string_view rest = cursor.line();
  const std::size_t hash = rest.find('#');
  if (hash != std::string_view::npos) rest = rest.substr(hash + 1);
  for (std::string_view after = rest; !is_blank(after);) {
    if (take_number(after)) break;
    const std::string_view word = take_word(after);
    constexpr std::array<std::string_view, 6> names{"YY", "YYYY", "MM", "DD", "hh", "mm"};
    if (std::find(names.begin(), names.end(), word) == names.end()) break;
    ++header.date_columns;
    rest = after;
  }
  if (header.date_columns != 4 && header.date_columns != 5) {
    cursor.fail("the date columns YY MM DD hh and perhaps mm",
                fmt::format("\"{}\"", printable(cursor.line())),
                "an NDBC spectral file starts with a line such as #YY MM DD hh mm .0200 .0325");
  }
  std::string_view after = rest;
  if (!take_number(after)) {
    header.quantity = stated_quantity(cursor);
    header.has_separation_frequency = rest.find("Sep_Freq") != std::string_view::npos;
    return header;
  }
  while (!is_blank(rest)) {
    const std::optional<double> frequency_hz = take_number(rest);
    if (!frequency_hz) {
      cursor.fail("a frequency in Hz", fmt::format("\"{}\"", printable(take_word(rest))),
                  "list all frequencies in the header, in Hz");
    }
    header.frequencies_hz.push_back(*frequency_hz);
  }
  return header;
}

UtcTime parse_date(TextCursor& cursor, int date_columns) {
  std::array<int, 5> fields{};
  for (int i = 0; i < date_columns; ++i) {
    const std::optional<double> number = take_number(cursor.rest());
    if (!number || *number != std::floor(*number) || *number < 0.0 || *number > 9999.0) {
      cursor.fail("a date such as 2020 06 08 03 50", fmt::format("\"{}\"", printable(cursor.line())),
                  "every row starts with year, month, day, hour and perhaps minute");
    }
    fields[i] = static_cast<int>(*number);
  }
  // Two-digit years: NDBC's archive begins in 1970.
  if (fields[0] < 100) fields[0] += fields[0] >= 70 ? 1900 : 2000;
  const UtcTime time{fields[0], fields[1], fields[2], fields[3], fields[4], 0};
  if (!is_valid(time)) {
    cursor.fail("a date such as 2020 06 08 03 50",
                fmt::format("\"{} {} {} {} {}\"", fields[0], fields[1], fields[2], fields[3], fields[4]),
                "correct the date: there is no such day or hour");
  }
  return time;
}

std::optional<double> parse_value(TextCursor& cursor, std::string_view expected) {
  std::string_view rest = cursor.rest();
  if (take_word(rest) == "MM") {
    cursor.rest() = rest;
    return std::nullopt;
  }
  if (is_blank(cursor.rest())) {
    cursor.fail(expected, "the end of the line",
                "the row is cut short or has fewer columns than the header: get the file again");
  }
  const double value = cursor.need_number(expected);
  return value >= missing_from ? std::nullopt : std::optional(value);
}

double parse_bracketed_frequency(TextCursor& cursor) {
  std::string_view& rest = cursor.rest();
  std::string_view word = take_word(rest);
  std::optional<double> frequency_hz;
  if (word.starts_with('(') && word.ends_with(')')) {
    std::string_view inner = word.substr(1, word.size() - 2);
    frequency_hz = take_number(inner);
    if (!is_blank(inner)) frequency_hz.reset();
  }
  if (!frequency_hz) {
    cursor.fail("a frequency in brackets such as (0.033)", fmt::format("\"{}\"", printable(word)),
                "realtime rows hold pairs: value (frequency)");
  }
  return *frequency_hz;
}

std::vector<NdbcSample> parse_samples(TextCursor& cursor, const Header& header) {
  std::vector<NdbcSample> samples;
  if (header.is_historical()) {
    samples.reserve(header.frequencies_hz.size());
    for (const double frequency_hz : header.frequencies_hz) {
      samples.push_back({frequency_hz, parse_value(cursor, "a value for each frequency")});
    }
    if (!is_blank(cursor.rest())) {
      cursor.fail(fmt::format("{} values", header.frequencies_hz.size()),
                  fmt::format("more: \"{}\"", printable(cursor.rest())),
                  "every row must have one value for each frequency of the header");
    }
    const bool is_all_missing = std::all_of(samples.begin(), samples.end(), [](const NdbcSample& s) {
      return !s.value || *s.value == old_missing;
    });
    if (is_all_missing) {
      for (NdbcSample& sample : samples) sample.value.reset();
    }
    return samples;
  }
  if (header.has_separation_frequency) parse_value(cursor, "the separation frequency in Hz");
  while (!is_blank(cursor.rest())) {
    const std::optional<double> value = parse_value(cursor, "a value");
    samples.push_back({parse_bracketed_frequency(cursor), value});
  }
  return samples;
}

/// Values of 999 and above are missing, as is "MM", as is a whole row of 99 (older files).
/// Throws Error(bad_input) with file and line.
NdbcTable parse_ndbc_table(std::string_view text, std::string_view file_name) {
  TextCursor cursor(text, file_name);
  cursor.need_line("an NDBC header line");
  if (!is_header(cursor.line())) {
    cursor.fail("an NDBC header line starting with #YY", fmt::format("\"{}\"", printable(cursor.line())),
                "an NDBC spectral file starts with a line such as #YY MM DD hh mm .0200 .0325");
  }
  NdbcTable table;
  Header header;
  do {
    // Yearly files repeat the header where a buoy changed its frequencies.
    if (is_header(cursor.line())) {
      header = parse_header(cursor);
      table.quantity = header.quantity;
      continue;
    }
    NdbcRow row;
    row.line_number = cursor.line_number();
    row.time = parse_date(cursor, header.date_columns);
    row.samples = parse_samples(cursor, header);
    double last_hz = 0.0;
    for (const NdbcSample& sample : row.samples) {
      if (sample.frequency_hz <= last_hz) {
        cursor.fail(fmt::format("a frequency above {:g} Hz", last_hz),
                    fmt::format("{:g}", sample.frequency_hz),
                    "frequencies must be positive, each greater than the one before");
      }
      last_hz = sample.frequency_hz;
    }
    table.rows.push_back(std::move(row));
  } while (cursor.next_filled_line());
  return table;
}

// Companions print the same frequencies; half the last of three digits tells neighbours (0.005 Hz apart)
// apart.
constexpr double same_frequency_hz = 0.0005 + 1e-9;

[[noreturn]] void fail_in_row(std::string_view file_name, const NdbcRow& row, const std::string& what,
                              const std::string& hint) {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}:{}: {}", printable_name(file_name), row.line_number, what), hint);
}

/// One companion file, its rows found by time.
class Companion {
 public:
  Companion(const std::optional<NamedText>& source, NdbcQuantity quantity, double lowest, double highest) {
    if (!source) return;
    file_name_ = source->file_name;
    table_ = parse_ndbc_table(source->text, file_name_);
    if (table_.quantity != NdbcQuantity::unstated && table_.quantity != quantity) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}:1: expected the columns that the file's name promises, got others",
                              printable_name(file_name_)),
                  "name the files .swdir (alpha1), .swdir2 (alpha2), .swr1 and .swr2, as NDBC does");
    }
    for (const NdbcRow& row : table_.rows) {
      row_of_time_.emplace(row.time, &row);
      for (const NdbcSample& sample : row.samples) {
        if (!sample.value) continue;
        largest_ = std::max(largest_, *sample.value);
        if (*sample.value < lowest || *sample.value > highest) {
          fail_in_row(
              file_name_, row,
              fmt::format("expected a value within [{:g}, {:g}], got {:g}", lowest, highest, *sample.value),
              "correct the value, or write 999 if it is missing");
        }
      }
    }
  }

  const NdbcRow* row_at(const UtcTime& time) const {
    const auto found = row_of_time_.find(time);
    return found == row_of_time_.end() ? nullptr : found->second;
  }

  double largest() const { return largest_; }

 private:
  std::string file_name_;
  NdbcTable table_;
  std::map<UtcTime, const NdbcRow*> row_of_time_;
  double largest_ = 0.0;
};

std::optional<double> value_at(const NdbcRow* row, double frequency_hz) {
  if (!row) return std::nullopt;
  const auto found =
      std::lower_bound(row->samples.begin(), row->samples.end(), frequency_hz - same_frequency_hz,
                       [](const NdbcSample& sample, double f_hz) { return sample.frequency_hz < f_hz; });
  if (found == row->samples.end() || found->frequency_hz > frequency_hz + same_frequency_hz)
    return std::nullopt;
  return found->value;
}

/// alpha_n and r_n of one order n: the moments of where waves travel to.
class MomentFiles {
 public:
  MomentFiles(int order, const std::optional<NamedText>& alpha, NdbcQuantity alpha_quantity,
              const std::optional<NamedText>& r, NdbcQuantity r_quantity)
      : order_(order),
        alpha_(alpha, alpha_quantity, 0.0, 360.0),
        r_(r, r_quantity, 0.0, 100.0),
        r_unit_(r_.largest() > 1.5 ? 0.01 : 1.0) {}

  std::optional<std::complex<double>> moment(const UtcTime& time, double frequency_hz) const {
    const std::optional<double> alpha_deg = value_at(alpha_.row_at(time), frequency_hz);
    const std::optional<double> r = value_at(r_.row_at(time), frequency_hz);
    if (!alpha_deg || !r) return std::nullopt;
    return std::polar(*r * r_unit_, order_ * direction_from_origin_bearing(*alpha_deg * degree_rad));
  }

 private:
  int order_;
  Companion alpha_;
  Companion r_;
  double r_unit_;
};

// "41010" of 41010.data_spec and of 41010w2020.txt.
std::string station_name(std::string_view file_name) {
  const std::filesystem::path path = unpacked_name(std::string(file_name));
  std::string stem = path.stem().string();
  if (const auto companions = ndbc_companion_paths(path); companions && path.extension() == ".txt") {
    stem.resize(stem.size() - 5);
  }
  return stem;
}

WaveSpectrum read_energy(const NdbcRow& row, std::string_view file_name) {
  WaveSpectrum spectrum;
  spectrum.time_utc = iso_time(row.time).value_or("");
  for (const NdbcSample& sample : row.samples) {
    if (!sample.value) continue;
    if (*sample.value < 0.0) {
      fail_in_row(file_name, row,
                  fmt::format("expected a variance density >= 0 m^2/Hz, got {:g} at {:g} Hz", *sample.value,
                              sample.frequency_hz),
                  "correct the value, or write 999 if it is missing");
    }
    spectrum.frequencies_hz.push_back(sample.frequency_hz);
    spectrum.energy.push_back(*sample.value);
  }
  return spectrum;
}

}  // namespace

std::vector<WaveSpectrum> parse_ndbc(std::string_view text, std::string_view file_name,
                                     const NdbcCompanions& companions) {
  const NdbcTable table = parse_ndbc_table(text, file_name);
  if (table.quantity != NdbcQuantity::energy && table.quantity != NdbcQuantity::unstated) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:1: expected spectral densities, got directions or their moments",
                            printable_name(file_name)),
                "give the .data_spec file: Offing finds the directional files beside it");
  }
  const MomentFiles first(1, companions.alpha1, NdbcQuantity::alpha1, companions.r1, NdbcQuantity::r1);
  const MomentFiles second(2, companions.alpha2, NdbcQuantity::alpha2, companions.r2, NdbcQuantity::r2);
  const std::string station = station_name(file_name);

  std::vector<WaveSpectrum> spectra;
  for (const NdbcRow& row : table.rows) {
    WaveSpectrum spectrum = read_energy(row, file_name);
    if (spectrum.frequencies_hz.size() < 2) continue;
    spectrum.station = station;
    std::vector<ReportedMoments> moments(spectrum.frequencies_hz.size());
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const auto c1 = first.moment(row.time, spectrum.frequencies_hz[i]);
      const auto c2 = second.moment(row.time, spectrum.frequencies_hz[i]);
      if (!c1) continue;
      moments[i].kind = c2 ? ReportedMoments::Kind::both : ReportedMoments::Kind::first;
      moments[i].moments = {*c1, c2.value_or(0.0)};
    }
    set_moments(spectrum, moments);
    spectra.push_back(std::move(spectrum));
  }
  if (spectra.empty()) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected at least one row with two densities, got none", printable_name(file_name)),
        "choose another month or station: this file has only missing values, or none");
  }
  return spectra;
}

std::optional<NdbcCompanionPaths> ndbc_companion_paths(const std::filesystem::path& path) {
  if (path.extension() == ".data_spec") {
    const auto with = [&](const char* extension) {
      std::filesystem::path other = path;
      return other.replace_extension(extension);
    };
    return NdbcCompanionPaths{with(".swdir"), with(".swdir2"), with(".swr1"), with(".swr2")};
  }
  const std::string stem = path.stem().string();
  if (path.extension() != ".txt" || stem.size() < 6) return std::nullopt;
  const std::size_t letter = stem.size() - 5;
  const bool has_year = std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(letter) + 1, stem.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
  if (stem[letter] != 'w' || !has_year) return std::nullopt;
  const auto with = [&](char other_letter) {
    std::string other = stem;
    other[letter] = other_letter;
    return path.parent_path() / (other + ".txt");
  };
  return NdbcCompanionPaths{with('d'), with('i'), with('j'), with('k')};
}

}  // namespace offing::spectra
