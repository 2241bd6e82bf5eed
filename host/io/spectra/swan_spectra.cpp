#include "host/io/spectra/swan_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/utc_time.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

/// How a SWAN file measures directions.
enum class SwanDirections { nautical, cartesian };

struct SwanLocation {
  std::string station;
  std::optional<double> latitude_deg;
  std::optional<double> longitude_deg;
};

/// One of the quantities that the file tabulates.
struct SwanQuantity {
  enum class Kind { density, direction, spread };
  Kind kind;
  SwanDirections convention = SwanDirections::nautical;  ///< of a direction
  double unit = 1.0;       ///< density: m^2/Hz (1-D) or m^2/Hz/rad (2-D) per unit of the file
  double exception_value;  ///< stands for "no value"
};

/// Everything in a SWAN spectral file above its first spectrum.
struct SwanHeader {
  int time_coding = 0;  ///< 0: a stationary file, without times
  std::vector<SwanLocation> locations;
  std::vector<double> frequencies_hz;
  std::size_t file_direction_count = 0;     ///< 0 in one-dimensional files
  std::optional<DirectionGrid> directions;  ///< two-dimensional files
  std::vector<SwanQuantity> quantities;
};

// The header has at most this many quantities: density, direction, spread.
constexpr std::size_t most_quantities = 3;

// The next line that is not a comment ("$ ...").
void need_header_line(TextCursor& cursor, std::string_view expected) {
  do {
    cursor.need_line(expected);
  } while (cursor.line().starts_with('$'));
}

std::string_view first_word(const TextCursor& cursor) {
  std::string_view rest = cursor.line();
  return take_word(rest);
}

double need_value(TextCursor& cursor, std::string_view expected) {
  need_header_line(cursor, expected);
  return cursor.need_number(expected);
}

std::size_t count_on_next_line(TextCursor& cursor, std::string_view expected) {
  need_header_line(cursor, expected);
  return cursor.need_count(expected);
}

std::vector<double> need_column(TextCursor& cursor, std::string_view count_of, std::string_view what) {
  std::vector<double> values(count_on_next_line(cursor, count_of));
  for (double& value : values) value = need_value(cursor, what);
  return values;
}

std::vector<SwanLocation> parse_locations(TextCursor& cursor) {
  const std::string_view keyword = first_word(cursor);
  const bool is_geographic = keyword == "LONLAT";
  if (!is_geographic && keyword != "LOCATIONS") {
    cursor.fail("LONLAT or LOCATIONS", fmt::format("\"{}\"", printable(cursor.line())),
                "a SWAN spectral file lists its locations after the time coding");
  }
  const std::size_t count = count_on_next_line(cursor, "the number of locations");
  std::vector<SwanLocation> locations;
  for (std::size_t number = 1; number <= count; ++number) {
    const double x = need_value(cursor, "the coordinates of a location");
    const double y = cursor.need_number("the second coordinate of a location");
    if (is_geographic) {
      locations.push_back({fmt::format("location {}", number), y, x});
    } else {
      locations.push_back({fmt::format("location {} (x {:g} m, y {:g} m)", number, x, y), {}, {}});
    }
  }
  return locations;
}

/// Direction of travel, rad, of `angle_deg` as the file measures it.
double swan_direction_rad(double angle_deg, SwanDirections convention) {
  const double angle_rad = angle_deg * degree_rad;
  return convention == SwanDirections::nautical ? direction_from_origin_bearing(angle_rad)
                                                : direction_from_cartesian(angle_rad);
}

// Stands on the keyword (NDIR, CDIR) of the directions of a two-dimensional file.
void parse_directions(TextCursor& cursor, SwanHeader& header) {
  const SwanDirections convention =
      first_word(cursor) == "NDIR" ? SwanDirections::nautical : SwanDirections::cartesian;
  std::vector<double> directions = need_column(cursor, "the number of directions", "a direction in degrees");
  for (double& angle : directions) angle = swan_direction_rad(angle, convention);
  header.file_direction_count = directions.size();
  header.directions.emplace(std::move(directions), cursor.place());
}

double density_unit(TextCursor& cursor, std::string_view name, const SwanHeader& header) {
  const bool is_2d = header.directions.has_value();
  const bool is_energy = name == "EnDens";
  const std::string expected = fmt::format("{}{}", is_energy ? "J/m2/Hz" : "m2/Hz", is_2d ? "/degr" : "");
  const std::string_view unit = first_word(cursor);
  if (unit != expected) {
    cursor.fail("the unit " + expected, fmt::format("\"{}\"", printable(unit)),
                "write the spectra in SWAN's own units");
  }
  return (is_energy ? 1.0 / energy_of_variance_jpm4 : 1.0) / (is_2d ? degree_rad : 1.0);
}

SwanQuantity parse_quantity(TextCursor& cursor, const SwanHeader& header) {
  need_header_line(cursor, "the name of a quantity");
  const std::string_view name = first_word(cursor);
  SwanQuantity quantity{};
  if (name == "VaDens" || name == "EnDens") {
    need_header_line(cursor, "the unit of the densities");
    quantity.unit = density_unit(cursor, name, header);
    quantity.kind = SwanQuantity::Kind::density;
  } else if (name == "NDIR" || name == "CDIR" || name == "DSPRDEGR" || name == "DEGR") {
    quantity.kind = name.ends_with("DIR") ? SwanQuantity::Kind::direction : SwanQuantity::Kind::spread;
    quantity.convention = name == "CDIR" ? SwanDirections::cartesian : SwanDirections::nautical;
    need_header_line(cursor, "the unit degr");
    if (first_word(cursor) != "degr") {
      cursor.fail("the unit degr", fmt::format("\"{}\"", printable(cursor.line())),
                  "write the spectra in SWAN's own units");
    }
  } else {
    cursor.fail("VaDens, EnDens, NDIR, CDIR or DSPRDEGR", fmt::format("\"{}\"", printable(name)),
                "write the file with SWAN's SPECOUT command");
  }
  quantity.exception_value = need_value(cursor, "the exception value");
  return quantity;
}

void parse_quantities(TextCursor& cursor, SwanHeader& header) {
  if (first_word(cursor) != "QUANT") {
    cursor.fail("QUANT", fmt::format("\"{}\"", printable(cursor.line())),
                "a SWAN spectral file names its quantities after the frequencies and directions");
  }
  const std::size_t count = count_on_next_line(cursor, "the number of quantities");
  if (count > most_quantities || (header.directions && count != 1)) {
    cursor.fail(header.directions ? "one quantity" : "at most three quantities", fmt::format("{}", count),
                "write the file with SWAN's SPECOUT command");
  }
  std::size_t densities = 0;
  for (std::size_t i = 0; i < count; ++i) {
    header.quantities.push_back(parse_quantity(cursor, header));
    densities += header.quantities.back().kind == SwanQuantity::Kind::density ? 1 : 0;
  }
  if (densities != 1) {
    cursor.fail("one density among the quantities", fmt::format("{}", densities),
                "write the file with SWAN's SPECOUT command");
  }
}

/// Reads the header; the cursor then stands on the header's last line. Throws Error(bad_input) with file and
/// line.
SwanHeader parse_swan_header(TextCursor& cursor) {
  need_header_line(cursor, "SWAN and the version 1");
  std::string_view rest = cursor.line();
  if (take_word(rest) != "SWAN" || take_number(rest) != 1.0) {
    cursor.fail("SWAN and the version 1", fmt::format("\"{}\"", printable(cursor.line())),
                "version 1 is what SWAN's SPECOUT command writes");
  }
  SwanHeader header;
  need_header_line(cursor, "TIME or the locations");
  if (first_word(cursor) == "TIME") {
    const double coding = need_value(cursor, "a time coding option");
    if (coding < 1.0 || coding > 6.0 || coding != std::floor(coding)) {
      cursor.fail("a time coding option within [1, 6]", fmt::format("{:g}", coding),
                  "1 is ISO notation, 19870530.153000");
    }
    header.time_coding = static_cast<int>(coding);
    need_header_line(cursor, "the locations");
  }
  header.locations = parse_locations(cursor);

  need_header_line(cursor, "AFREQ or RFREQ");
  if (first_word(cursor) != "AFREQ" && first_word(cursor) != "RFREQ") {
    cursor.fail("AFREQ or RFREQ", fmt::format("\"{}\"", printable(cursor.line())),
                "the number of locations before it may be wrong");
  }
  header.frequencies_hz = need_column(cursor, "the number of frequencies", "a frequency in Hz");
  check_frequencies(header.frequencies_hz, cursor.place());

  need_header_line(cursor, "NDIR, CDIR or QUANT");
  if (first_word(cursor) == "NDIR" || first_word(cursor) == "CDIR") {
    parse_directions(cursor, header);
    need_header_line(cursor, "QUANT");
  }
  parse_quantities(cursor, header);
  return header;
}

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
              "check the lines of the record before it: there may be too many or too few");
}

// The next values of the cursor's line and those after it.
std::vector<double> read_values(TextCursor& cursor, std::size_t count) {
  if (count > cursor.text_size()) {
    cursor.fail("as many values as the header says", fmt::format("a file too short for {}", count),
                "the header is damaged or the file is cut short: write it again");
  }
  std::vector<double> values(count);
  for (double& value : values) value = cursor.need_number("a value of the spectrum");
  if (!is_blank(cursor.rest())) {
    cursor.fail("the end of the record", fmt::format("\"{}\"", printable(cursor.rest())),
                "the record has more values than the header says: write the file again");
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
                "check the lines of the record before it: there may be too many or too few");
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
        cursor.fail("as many spectra as the file's size can hold", "more",
                    "the header is damaged: write the file again");
      }
      spectra.push_back(std::move(*spectrum));
    }
  };
  if (header.time_coding == 0) {
    read_all_locations("");
    if (cursor.next_filled_line()) {
      cursor.fail("the end of the file", fmt::format("\"{}\"", printable(cursor.line())),
                  "without TIME in the header there is one record per location");
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
        "choose points at sea: every location is marked NODATA");
  }
  return spectra;
}

}  // namespace offing::spectra
