#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "host/base/wave_spectrum.h"
#include "host/io/atomic_file.h"

namespace offing {

/// Writes directional spectra as WAVEWATCH III point spectra (text; spectra::parse_ww3() tells the layout),
/// whole or not at all, the oldest first. Other readers of this format take counts of two digits only: of
/// more than 99 directions or frequencies there are fewer in the file, of the same variance. Densities have
/// seven digits, those below 1e-99 m^2/Hz/rad become 0. Spectra of one time form one block; every block must
/// have as many points as the first. Unknown positions are written as -999, unknown depths as -999, unknown
/// times as year 1; wind and current, which a WaveSpectrum does not hold, as 0.
///
/// Throws Error(bad_input) if `spectra` is empty, one has no directions, or they differ in frequencies,
/// directions or points a time; Error(file) if the file cannot be written.
void write_ww3_spectra(const std::filesystem::path& path, std::span<const WaveSpectrum> spectra,
                       Existing existing = Existing::replace);

/// The text of that file; errors name `path`.
std::string ww3_text(const std::filesystem::path& path, std::span<const WaveSpectrum> spectra);

}  // namespace offing
