// A program of somebody who has Offing installed: it includes by the installed paths.
#include <cstdio>

#include "host/base/error.h"
#include "host/base/wave_spectrum.h"

int main() {
  offing::WaveSpectrum sea;
  sea.frequencies_hz = {0.1, 0.2};
  sea.energy = {1.0, 1.0};
  const double variance_m2 = offing::variance_m2(sea);
  std::printf("m0 = %g m^2\n", variance_m2);
  const bool is_right = variance_m2 > 0.0999 && variance_m2 < 0.1001;
  return is_right && offing::exit_code(offing::ErrorKind::no_device) == 3 ? 0 : 1;
}
