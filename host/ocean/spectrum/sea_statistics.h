#pragma once

#include <span>

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/gerstner_waves.h"

namespace offing::ocean {

/// Energies of the waves of one cascade: energy [size][size] m^2, row-major, K = 0 at [0][0], index n >= size
/// / 2 standing for n - size; rows along z, columns along x. Each cell is the variance that the wave
/// *travelling* toward +K adds to the surface, so that the sum over all cells of all cascades is m0.
///
/// With h(K) = h0(K) e^(-i w t) + conj(h0(-K)) e^(+i w t) a realised wave has energy 2 |h0(K)|^2; its
/// expectation is V(K) = P(K) (2 pi / L)^2, and as |h0|^2 of a complex Gaussian it is exponentially
/// distributed.
struct ModeEnergies {
  double patch_length_m = 0.0;
  int size = 0;
  std::span<const float> energy;
};

/// One standard deviation of what sea_state_of() gives for a realised sea, averaged over seeds.
struct SeaStateError {
  double hs_m = 0.0;
  double peak_period_s = 0.0;
  double tm02_s = 0.0;
  double mean_direction_rad = 0.0;
};

/// The sea state of these waves of a spectrum, modes of cascades and Gerstner waves. Moments are sums over
/// waves. tp_s
/// needs a density: energies are gathered in bins of 1/16 octave of frequency, or of one step of the longest
/// patch's wavenumbers where that is wider, since narrower ones would see the lattice instead of the sea. The
/// peak period is that of peak_of() in bins of 1 %, which takes the shape of the peak from the spectrum; the
/// peak direction is that of waves within 5 % of it.
/// Throws Error(bad_input) when an array is not [size][size] or patch_length_m is not positive.
SeaState sea_state_of(std::span<const ModeEnergies> cascades, const SeaSpectrum& spectrum,
                      std::span<const GerstnerWave> gerstner_waves = {});

/// Standard errors of the mean over `seeds` >= 1 independent seas with these expected energies V, to first
/// order in the scatter (delta method). Energies of different waves are independent and exponential, so Var e
/// = V^2; for an estimator T(m) of sums m = sum of c e, Var T = sum of (dT/de)^2 V^2 / seeds:
///   Hs = 4 sqrt(m0)             dHs/de   = Hs / (2 m0)
///   Tm02 = sqrt(m0 / m2)        dTm02/de = Tm02 / 2 (1/m0 - f^2/m2)
///   peak period                 as DensityPeak::error has it
///   theta = atan2(b, a)         dtheta/de = (a sin - b cos) / (a^2 + b^2), a, b = sums of e cos, e sin
/// This holds for energies of travelling waves. The variance over a patch at one instant contains the product
/// of the waves along +K and -K besides: it scatters as the sum of (V(K) + V(-K))^2 / 2, which is the same
/// where one of the two is absent, and twice as much for a sea symmetric in +-K. Gerstner waves have the same
/// energy for every seed and add no scatter to Hs; how their drawn frequencies and directions scatter is left
/// out of the others.
SeaStateError standard_error_of(std::span<const ModeEnergies> expected, const SeaSpectrum& spectrum,
                                int seeds, std::span<const GerstnerWave> gerstner_waves = {});

}  // namespace offing::ocean
