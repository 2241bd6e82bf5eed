#pragma once

#include <filesystem>
#include <vector>

#include "host/base/wave_spectrum.h"
#include "host/io/file_trust.h"

namespace offing {

/// All records of a wave spectrum file, in file order. The format is found by content, then by name: NDBC
/// realtime (.data_spec) and historical text with the directional files beside them
/// (spectra::NdbcCompanionPaths), WAVEWATCH III and SWAN as text and as NetCDF, NetCDF of wavespectra,
/// Datawell .spt, TRIAXYS, Octopus, Spotter as CSV and as JSON. See the parse_...() functions of this folder
/// for what each holds. Never empty.
///
/// Throws Error(bad_input) if there is no such file, it cannot be read, is no regular file, larger than 1
/// GiB, of no known format or damaged: what() names file and line. Logs a warning if only some of the
/// directional files of an NDBC spectrum are there. No error shows the content of a file that is not a
/// spectrum. With Trust::untrusted, companions lie in the folder of the file or below, and HDF5 (NetCDF-4) is
/// refused: it can name other files of the machine as its data.
std::vector<WaveSpectrum> read_spectra(const std::filesystem::path& path, Trust trust = Trust::trusted);

}  // namespace offing
