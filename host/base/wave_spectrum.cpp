#include "host/base/wave_spectrum.h"

namespace offing {

double variance_m2(const WaveSpectrum& spectrum) {
  double m0 = 0.0;
  for (std::size_t i = 1; i < spectrum.frequencies_hz.size(); ++i) {
    const double width_hz = spectrum.frequencies_hz[i] - spectrum.frequencies_hz[i - 1];
    m0 += 0.5 * (spectrum.energy[i] + spectrum.energy[i - 1]) * width_hz;
  }
  return m0;
}

}  // namespace offing
