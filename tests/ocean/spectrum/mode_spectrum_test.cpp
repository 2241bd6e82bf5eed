#include "host/ocean/spectrum/mode_spectrum.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

SeaMode deep_water_wave(double amplitude_m, double frequency_hz, double direction_rad) {
  const double omega_radps = 2.0 * std::numbers::pi * frequency_hz,
               k_radpm = omega_radps * omega_radps / 9.81;
  return {.amplitude_m = amplitude_m,
          .kx_radpm = k_radpm * std::cos(direction_rad),
          .kz_radpm = k_radpm * std::sin(direction_rad),
          .omega_radps = omega_radps,
          .phase_rad = 0.0,
          .patch = 0};
}

// Fails if energy is lost or moves to another frequency or direction on the whole: m0 = 0.5 + 0.125 m^2, Tm01
// of 0.5 at 0.1 Hz and 0.125 at 0.2 Hz, and the direction of the waves' moment. E is linear in between: the
// mean frequency of a node's triangle is a third of a step squared above it, 4e-5 for steps of 1.1 %. Limit
// 1e-4.
TEST(ModeSpectrum, KeepsVarianceFrequencyAndDirection) {
  const ModalSea modes{.modes = {deep_water_wave(1.0, 0.1, 0.5),
                                 deep_water_wave(0.5, 0.2, 6.0),
                                 {.amplitude_m = 3.0, .omega_radps = 1.0}},
                       .patch_lengths_m = {1000.0}};
  const SeaState state = integrate_sea_state(from_measured(spectrum_of(modes), {}, {}));
  EXPECT_NEAR(state.m0_m2, 0.625, 1e-4 * 0.625);
  EXPECT_NEAR(1.0 / state.tm01_s, (0.5 * 0.1 + 0.125 * 0.2) / 0.625, 1e-4 * 0.12);
  const double x = 0.5 * std::cos(0.5) + 0.125 * std::cos(6.0),
               z = 0.5 * std::sin(0.5) + 0.125 * std::sin(6.0);
  // A direction goes to the two beside it, at most 5 degrees apart: the mean moves by less than 2e-3 rad.
  EXPECT_NEAR(state.mean_direction_rad, std::atan2(z, x), 2e-3);
}

// Fails if waves of one frequency have no band, or a sea without waves on patches one.
TEST(ModeSpectrum, HandlesOneWaveAndNone) {
  const WaveSpectrum one =
      spectrum_of({.modes = {deep_water_wave(2.0, 0.1, 0.0)}, .patch_lengths_m = {1000.0}});
  EXPECT_NEAR(variance_m2(one), 2.0, 1e-12);
  test::expect_error(ErrorKind::bad_input, "expected waves on a patch",
                     [] { spectrum_of({.modes = {{.amplitude_m = 1.0, .omega_radps = 1.0}}}); });
}

}  // namespace
}  // namespace offing::ocean
