#pragma once

#include <filesystem>
#include <vector>

#include "host/io/file_trust.h"
#include "host/io/hydrodynamics/hydrodynamic_table.h"
#include "host/io/hydrodynamics/wamit_files.h"

namespace offing {

/// Added mass, damping and excitation of a hull: the NetCDF file of Capytaine, or WAMIT's numeric output, for
/// which `path` is one of the files NAME.1, NAME.3 and NAME.hst; the first two must be there. `units` are for
/// WAMIT's.
///
/// Throws Error(bad_input) if a file is not there, cannot be read, is larger than 256 MiB, of no known format
/// or damaged: what() names the file and the place. With Trust::untrusted, files lie in the folder of `path`
/// or below, and HDF5 (NetCDF-4) is refused: it can name other files of the machine as its data.
hydrodynamics::HydrodynamicFile read_hydrodynamics(const std::filesystem::path& path,
                                                   const hydrodynamics::WamitUnits& units = {},
                                                   Trust trust = Trust::trusted);

/// All that read_hydrodynamics() reads for `path`: with WAMIT's output NAME.1, NAME.3 and, if it is there,
/// NAME.hst.
std::vector<std::filesystem::path> hydrodynamic_files(const std::filesystem::path& path);

}  // namespace offing
