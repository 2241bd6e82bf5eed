#include "host/io/spectra/ndbc_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

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
                  "the header must list the frequencies");
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
                "there is no such day or hour");
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
    cursor.fail(expected, "the end of the line", "the row has fewer columns than the header or is cut short");
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

}  // namespace

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

}  // namespace offing::spectra
