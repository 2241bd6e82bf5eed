#include "host/io/spectra/netcdf_module.h"

#include "host/io/module.h"

namespace offing::spectra {
namespace {

constexpr NetcdfModule table{.parse_netcdf = parse_netcdf,
                             .read_variables = read_netcdf_variables,
                             .read_arrays = read_netcdf_arrays,
                             .create = create_netcdf};

}  // namespace
}  // namespace offing::spectra

OFFING_MODULE(offing::spectra::table);
