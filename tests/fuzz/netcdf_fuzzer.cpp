// Classic NetCDF only: NetCDF-4 files are taken apart by libhdf5, which leaks memory on damaged ones; that
// would be reported here within seconds and cannot be fixed here.

#include <cstddef>
#include <cstdint>

#include "host/io/spectra/netcdf_spectra.h"
#include "tests/fuzz/spectrum_fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (!bytes.starts_with("CDF")) return -1;  // do not keep it
  return offing::fuzz::check_reader(
      [&] { return offing::spectra::parse_netcdf(std::as_bytes(std::span(data, size)), "fuzz"); });
}
