#pragma once

#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// Spectra of a Sofar Spotter buoy, in file order: the CSV of its dashboard, a record a line, or the JSON of
/// its interface, with the list `frequencyData`.
///
/// Densities are m^2/Hz. a1, b1, a2, b2 are the moments of where waves travel to, counterclockwise from east;
/// spreading is maximum_entropy_spreading() of them. Without them, it is cosine_power_spreading() of
/// `direction`, degrees clockwise from north that waves come from, and `directionalSpread`, sqrt(2 (1 - r1))
/// in degrees (Kuik, van Vledder and Holthuijsen 1988). Values that are no numbers are missing: a frequency
/// without a density is left out, as are records with fewer than two.
///
/// Throws Error(bad_input) with file and line, or the place in the JSON; also if no record holds data.
/// Source: Sofar Ocean, Spotter API documentation.
std::vector<WaveSpectrum> parse_spotter(std::string_view text, std::string_view file_name);

/// Whether a file that begins with this line may be one.
bool is_spotter(std::string_view first_filled_line);

}  // namespace offing::spectra
