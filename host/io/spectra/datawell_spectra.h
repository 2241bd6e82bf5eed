#pragma once

#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// One Datawell Waverider spectrum (.spt): twelve lines of system values, of which the fourth is the largest
/// density Smax in m^2/Hz, then a line a frequency: f in Hz, S/Smax, direction, spread, skewness, kurtosis.
/// Directions are degrees clockwise from north where waves come *from*. A line of f and S/Smax alone (a buoy
/// that does not measure directions) is read too.
///
/// With m1, m2, n2 the moments about the mean direction, turned clockwise (Kuik, van Vledder, Holthuijsen
/// 1988): spread = sqrt(2 (1 - m1)), skewness = -n2 / ((1 - m2) / 2)^1.5, kurtosis = (6 - 8 m1 + 2 m2) /
/// spread^4. m2 and n2 from them, limited as admissible_moments() says, give maximum_entropy_spreading().
///
/// Station and time come from the file's name, "buoy}2024-09-09T01h15Z.spt". Throws Error(bad_input) with
/// file and line.
std::vector<WaveSpectrum> parse_datawell(std::string_view text, std::string_view file_name);

}  // namespace offing::spectra
