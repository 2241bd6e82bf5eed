#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "host/io/hydrodynamics/hydrodynamic_table.h"
#include "host/io/spectra/netcdf_variables.h"

namespace offing::hydrodynamics {

/// The dataset of one rigid body as Capytaine 2.1 and later write it (export_dataset,
/// save_dataset_as_netcdf): added_mass, radiation_damping, excitation_force, hydrostatic_stiffness if there,
/// over omega, wave_direction, influenced_dof and radiating_dof. Throws Error(bad_input) naming file and
/// variable.
HydrodynamicFile parse_capytaine(std::span<const std::byte> bytes, std::string_view file_name,
                                 decltype(&spectra::read_netcdf_arrays) read_arrays);

}  // namespace offing::hydrodynamics
