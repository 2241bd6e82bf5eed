#include "host/io/spectra/netcdf_module.h"

#include "host/io/module.h"

namespace offing::spectra {
namespace {

constexpr NetcdfModule table{.parse_netcdf = parse_netcdf};

}  // namespace
}  // namespace offing::spectra

OFFING_MODULE(offing::spectra::table);
