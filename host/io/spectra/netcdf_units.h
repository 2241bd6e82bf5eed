#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace offing::spectra {

/// A spectral density's unit.
struct DensityUnit {
  double in_si;         ///< m^2/Hz/rad or m^2/Hz in one of it
  bool is_directional;  ///< per rad or degree
};

/// Reads "m2 s rad-1", "m2/Hz/degr", "m**2 s deg**-1", "J m-2 Hz-1 rad-1" and the like; nothing for other
/// text.
std::optional<DensityUnit> parse_density_unit(std::string_view text);

/// Hz in one unit of frequency: "s-1", "Hz", "rad s-1" and the like.
std::optional<double> parse_frequency_unit(std::string_view text);

/// Radians in one unit of direction: "degree", "degrees_true", "radians" and the like.
std::optional<double> parse_direction_unit(std::string_view text);

/// A time axis: "days since 1990-01-01 00:00:00".
struct TimeUnit {
  double seconds;            ///< in one unit
  std::int64_t origin_unix;  ///< seconds since 1970

  /// ISO 8601, to the second; empty if `value` is not finite or beyond the year 9999.
  std::string iso_time(double value) const;
};

std::optional<TimeUnit> parse_time_unit(std::string_view text);

}  // namespace offing::spectra
