#include "host/io/spectra/swan_header.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/spectra/bearings.h"
#include "host/io/spectra/swan_energy.h"

namespace offing::spectra {
namespace {

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

std::size_t need_count(TextCursor& cursor, std::string_view expected) {
  const double value = need_value(cursor, expected);
  // Each counted thing has a line of at least two bytes, so the size of the file bounds the count.
  const double most = static_cast<double>(cursor.text_size()) / 2.0;
  if (value < 1.0 || value > most || value != std::floor(value)) {
    cursor.fail(expected, fmt::format("{:g}", value), "the count does not fit the size of the file");
  }
  return static_cast<std::size_t>(value);
}

std::vector<double> need_column(TextCursor& cursor, std::string_view count_of, std::string_view what) {
  std::vector<double> values(need_count(cursor, count_of));
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
  const std::size_t count = need_count(cursor, "the number of locations");
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
  const std::size_t count = need_count(cursor, "the number of quantities");
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

}  // namespace

double swan_direction_rad(double angle_deg, SwanDirections convention) {
  const double angle_rad = angle_deg * degree_rad;
  return convention == SwanDirections::nautical ? direction_from_origin_bearing(angle_rad)
                                                : direction_from_cartesian(angle_rad);
}

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

}  // namespace offing::spectra
