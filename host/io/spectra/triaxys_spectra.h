#pragma once

#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// The spectrum of an AXYS TRIAXYS buoy, text of one record: lines `NAME = VALUE`, then numbers.
///
/// A NON-DIRECTIONAL SPECTRUM has lines of a frequency in Hz and a density in m^2/Hz. A DIRECTIONAL SPECTRUM
/// has a line of densities in m^2/Hz/degree for each frequency, INITIAL FREQUENCY and then every FREQUENCY
/// SPACING; its columns are the bearings that waves come from, 0 and then every DIRECTION SPACING degrees,
/// which may end with 360. North is that of the buoy's settings. The line of 0 Hz is left out.
///
/// Throws Error(bad_input) with file and line. Source: files of buoys.
std::vector<WaveSpectrum> parse_triaxys(std::string_view text, std::string_view file_name);

}  // namespace offing::spectra
