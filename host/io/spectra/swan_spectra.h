#pragma once

#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// SWAN's defaults for the density of sea water and for gravity, which turn energy in J/m^2 into variance.
inline constexpr double energy_of_variance_jpm4 = 1025.0 * 9.81;

/// SWAN spectral files, as text (format version 1): one spectrum a time and location that has data, in file
/// order.
///
/// Two-dimensional: VaDens in m2/Hz/degr or EnDens in J/m2/Hz/degr (divided by 1025 kg/m^3 x 9.81 m/s^2,
/// SWAN's defaults), NDIR (degrees clockwise from north, waves coming from) or CDIR (degrees counterclockwise
/// from the x axis, waves going to; the axis is taken to point east). FACTOR, ZERO (a calm sea, without
/// directions) and NODATA (left out) are known. One-dimensional: density, mean direction and, in degrees,
/// SWAN's spread sqrt(2 (1 - r1)); spreading is then cosine_power_spreading(). Relative frequencies (RFREQ)
/// are taken as they are. A frequency with an exception value for its density is left out of its record.
///
/// LONLAT locations become latitude and longitude, others part of the station's name. Throws Error(bad_input)
/// with file and line, also if no location holds data.
/// Source: SWAN user manual, appendix "Spectrum files, input and output".
std::vector<WaveSpectrum> parse_swan(std::string_view text, std::string_view file_name);

}  // namespace offing::spectra
