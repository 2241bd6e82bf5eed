#pragma once

#include <optional>
#include <string>
#include <vector>

namespace offing {

/// A sea state as instruments and wave models report it: energy against frequency, and how the energy of each
/// frequency spreads over directions. Made by host/io readers, consumed by host/ocean.
///
/// Between the listed frequencies energy and spreading are linear; outside them there is none, so that
/// m0 is the trapezoidal sum over the listed frequencies.
struct WaveSpectrum {
  std::string station;                  ///< name or number of the place, empty if unknown
  std::string time_utc;                 ///< ISO 8601, such as "2020-06-08T03:50Z", empty if unknown
  std::optional<double> latitude_deg;   ///< north positive
  std::optional<double> longitude_deg;  ///< east positive
  std::optional<double> depth_m;        ///< water depth, if the file gives it

  std::vector<double> frequencies_hz;  ///< [nf], > 0, strictly increasing, nf >= 2
  std::vector<double> energy;          ///< [nf] one-sided variance density E(f), m^2/Hz, >= 0

  /// [nd] directions of *travel*, rad, from +x (east) toward +z (south), strictly increasing within one turn,
  /// evenly spaced. Empty when the record has no directions: the consumer then chooses a spreading.
  std::vector<double> directions_rad;
  /// [nf][nd] row-major D(f, theta), 1/rad, >= 0, each row integrates to 1 (periodic rectangle rule).
  std::vector<double> spreading;

  bool is_directional() const { return !directions_rad.empty(); }
};

/// Zeroth moment m0 = integral of E(f) df, m^2, by the trapezoidal rule.
double variance_m2(const WaveSpectrum& spectrum);

}  // namespace offing
