// Data bases of hulls: classic NetCDF of Capytaine (HDF5: see netcdf_fuzzer.cpp), else WAMIT's three files,
// divided by lines of %.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "host/io/hydrodynamics/capytaine_file.h"
#include "host/io/hydrodynamics/wamit_files.h"
#include "tests/fuzz/expect.h"

using namespace offing;
using fuzz::expect;

namespace {

void expect_data(const hydrodynamics::HydrodynamicFile& file) {
  const HydrodynamicData& data = file.data;
  const std::size_t frequencies = data.frequencies_radps.size(), directions = data.directions_rad.size();
  expect(frequencies >= 2 && directions >= 1);
  expect(data.added_mass.size() == frequencies && data.damping.size() == frequencies);
  expect(data.excitation.size() == frequencies * directions);
  for (std::size_t i = 1; i < frequencies; ++i)
    expect(data.frequencies_radps[i] > data.frequencies_radps[i - 1]);
  for (std::size_t i = 1; i < directions; ++i) expect(data.directions_rad[i] > data.directions_rad[i - 1]);
  for (const HullMatrix& matrix : data.added_mass) {
    for (const double value : matrix) expect(std::isfinite(value));
  }
  for (const HullWrench& wrench : data.excitation) {
    for (const auto& value : wrench) expect(std::isfinite(std::abs(value)));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with("\x89HDF")) return -1;  // do not keep it
  return fuzz::check_reading([&] {
    if (bytes.starts_with("CDF")) {
      expect_data(hydrodynamics::parse_capytaine(std::as_bytes(std::span(data, size)), "fuzz",
                                                 spectra::read_netcdf_arrays));
      return;
    }
    std::array<std::string_view, 3> files;
    std::string_view rest = bytes;
    for (std::string_view& file : files) {
      const std::size_t end = std::min(rest.find("%\n"), rest.size());
      file = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 2, rest.size()));
    }
    expect_data(hydrodynamics::parse_wamit({files[0], "a.1"}, {files[1], "a.3"},
                                           hydrodynamics::WamitText{files[2], "a.hst"}, {}));
  });
}
