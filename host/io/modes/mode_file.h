#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/base/sea/modal_sea.h"
#include "host/io/atomic_file.h"
#include "host/io/file_trust.h"
#include "host/io/spectra/netcdf_variables.h"

namespace offing {

/// A file of ModalSea: a table with the columns amplitude_m, kx_radpm, kz_radpm, omega_radps, phase_rad and
/// perhaps patch, the index of a patch or -1, and facts beside it: patch_length_m (one a patch), size,
/// split_radpm, choppiness, depth_m, loop_period_s. Facts that are left out are those of a default ModalSea.
///
/// NetCDF: columns are variables of one dimension, facts variables of none but patch_length_m, which has its
/// own. CSV: lines `# fact = values` before a line of column names; kx, kz and omega have twelve digits,
/// amplitude and phase nine, so that phases are right to 1e-6 rad after 10^5 s and 10 km from the origin.

/// Reads NetCDF or CSV, whichever it is. Throws Error(bad_input) naming file, and line or variable, for what
/// is not such a file; for modes off their lattice, more than 128 alone, and values out of range. With
/// Trust::untrusted HDF5 (NetCDF-4) is refused.
ModalSea read_modes(const std::filesystem::path& path, Trust trust = Trust::trusted);

/// Writes NetCDF, or CSV where the name does not end in .nc, whole or not at all. Throws Error(file).
void write_modes(const std::filesystem::path& path, const ModalSea& modes,
                 Existing existing = Existing::replace);

/// The CSV.
std::string modes_csv(const ModalSea& modes);
ModalSea parse_modes_csv(std::string_view text, std::string_view file_name);

/// The same of a NetCDF file, by the function of the module `netcdf`.
ModalSea parse_modes_netcdf(std::string_view bytes, std::string_view file_name,
                            decltype(&spectra::read_netcdf_variables) read_variables);

}  // namespace offing
