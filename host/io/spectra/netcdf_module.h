#pragma once

#include "host/io/spectra/netcdf_spectra.h"

namespace offing::spectra {

/// The functions of the module `netcdf`.
struct NetcdfModule {
  decltype(&spectra::parse_netcdf) parse_netcdf;
};

}  // namespace offing::spectra
