#pragma once

#include "host/io/spectra/netcdf_output.h"
#include "host/io/spectra/netcdf_spectra.h"
#include "host/io/spectra/netcdf_variables.h"

namespace offing::spectra {

/// The functions of the module `netcdf`.
struct NetcdfModule {
  decltype(&spectra::parse_netcdf) parse_netcdf;
  decltype(&spectra::read_netcdf_variables) read_variables;
  decltype(&spectra::read_netcdf_arrays) read_arrays;
  decltype(&spectra::create_netcdf) create;
};

}  // namespace offing::spectra
