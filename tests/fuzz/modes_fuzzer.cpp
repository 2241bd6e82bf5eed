#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host/base/error.h"
#include "host/io/modes/mode_file.h"
#include "host/ocean/spectrum/mode_spectrum.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/mode_lattice.h"
#include "tests/fuzz/expect.h"

using offing::fuzz::expect;

namespace {

/// What is made of the waves before a device is: their spectrum, and their places on the lattices.
void expect_sea(const offing::ModalSea& sea) {
  using namespace offing::ocean;
  const auto cascades = cascades_from_patches(sea.patch_lengths_m, sea.size, sea.split_radpm);
  const offing::WaveSpectrum spectrum = spectrum_of(sea);
  for (const double energy : spectrum.energy) expect(energy >= 0.0);
  const SeaSpectrum made = from_measured(spectrum, {}, {});
  if (sea.size > 64) return;  // larger arrays take their time
  const int columns = std::max(sea.size / 2, 16);
  const std::size_t places = cascades.size() * static_cast<std::size_t>(columns) * static_cast<std::size_t>(sea.size);
  ModeArrays arrays;
  arrays.amplitude.resize(4 * places);
  arrays.rate.resize(places);
  const WaveClock clock(made.omega_max_radps / 6.28, sea.loop_period_s);
  place_modes(sea, {cascades, sea.size, columns}, clock, arrays);
  for (const float value : arrays.amplitude) expect(std::isfinite(value));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with("\x89HDF")) return -1;  // see netcdf_fuzzer.cpp
  try {
    expect_sea(bytes.starts_with("CDF")
                   ? offing::parse_modes_netcdf(bytes, "fuzz", offing::spectra::read_netcdf_variables)
                   : offing::parse_modes_csv(bytes, "fuzz"));
  } catch (const offing::Error& error) {
    offing::fuzz::expect_told(error);
  }
  return 0;
}
