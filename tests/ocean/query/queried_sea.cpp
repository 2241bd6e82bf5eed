#include "tests/ocean/query/queried_sea.h"

#include <numbers>
#include <random>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/gerstner_choice.h"

namespace offing::ocean {

HybridSea hybrid_sea(const ocl::Device& device, int size, double choppiness) {
  SpectrumParameters wind;
  wind.wind_speed_mps = 12.0;
  const SeaSpectrum spectrum = make_sea_spectrum(wind);
  const double peak_m =
      2.0 * std::numbers::pi / spectrum.dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
  const GerstnerChoice choice{.split_radpm = split_at_wavelength_radpm(peak_m / 3.0), .count = 16, .seed = 2};
  const OceanParameters parameters{.size = size,
                                   .cascades = choose_cascades(spectrum, size, 2, choice.split_radpm),
                                   .seed = 2,
                                   .choppiness = choppiness,
                                   .gerstner_waves = {.waves = choose_gerstner_waves(spectrum, choice),
                                                      .choppiness = choppiness,
                                                      .dispersion = spectrum.dispersion}};
  return {.spectrum = spectrum, .ocean = Ocean(device, spectrum, parameters)};
}

std::vector<WaterPoint> scattered_points(int count, double width_m) {
  std::mt19937_64 generator(1);
  const auto place_m = [&] { return (static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5) * width_m; };
  std::vector<WaterPoint> points;
  for (int i = 0; i < count; ++i) {
    const double x_m = place_m();
    points.push_back({x_m, place_m()});
  }
  return points;
}

}  // namespace offing::ocean
