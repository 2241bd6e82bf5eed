#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/io/spectra/spectrum_builder.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {

/// How a SWAN file measures directions.
enum class SwanDirections { nautical, cartesian };

/// Direction of travel, rad, of `angle_deg` as the file measures it.
double swan_direction_rad(double angle_deg, SwanDirections convention);

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

/// Reads the header; the cursor then stands on the header's last line. Throws Error(bad_input) with file and
/// line.
SwanHeader parse_swan_header(TextCursor& cursor);

}  // namespace offing::spectra
