#pragma once

#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// WAVEWATCH III spectra at points, as text: 'WAVEWATCH III SPECTRA' nf nd points 'grid', frequencies in Hz,
/// directions in rad, then for each time "YYYYMMDD HHMMSS" and for each point 'name', latitude, longitude,
/// depth m, wind and current, and nf x nd densities in m^2/Hz/rad, frequency running fastest. Directions are
/// of travel, clockwise from north. One spectrum a time and point, in file order.
///
/// A latitude outside [-90, 90], a depth <= 0 and the year 1 mean unknown (write_ww3_spectra() writes them
/// so). Throws Error(bad_input) with file and line. Source: WAVEWATCH III manual, "point output
/// post-processor", spectral transfer files.
std::vector<WaveSpectrum> parse_ww3(std::string_view text, std::string_view file_name);

}  // namespace offing::spectra
