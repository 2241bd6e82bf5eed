#pragma once

#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// Spectra of the Octopus format, comma-separated text of one or more sites, each with its records. A record
/// has a line for each bearing that waves come from, degrees clockwise from north, evenly spaced: the
/// bearing, the variance in m^2 of the waves of each frequency, their sum.
///
/// A variance becomes a density by the width of its frequency, half-way to both neighbours and at the ends to
/// the only one: the trapezoidal sum of WaveSpectrum is then the sum of the variances. Records with missing
/// values, which are negative, are left out.
///
/// Throws Error(bad_input) with file and line, also if no record holds data. Source: files of wave forecasts,
/// and the writer of wavespectra.
std::vector<WaveSpectrum> parse_octopus(std::string_view text, std::string_view file_name);

}  // namespace offing::spectra
