#pragma once

#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::ocean {

/// U10, m/s: the wind that makes a sea of this significant height and peak period, by the growth laws of
/// Hasselmann et al. 1973 over the fetch X. With m0 = Hs^2 / 16 and x = g X / U^2 they are
///   m0 g^2 / U^4 = 1.6e-7 x   and   omega_peak U / g = 22 x^(-1/3).
/// Eliminating x gives U = m0 omega_peak^3 / (1.6e-7 22^3 g), which grows as Hs^2 / Tp^3. For a swell, which
/// no local wind made, it is near 0. Clamped to 0.1 ... 100 m/s.
///
/// The spectrum of jonswap takes its energy from Hasselmann's law of alpha instead, and has more: its own
/// height and period give back a stronger wind (100 km of fetch at 12 m/s: 20.2 m/s).
double wind_of_height_and_period_mps(double hs_m, double peak_period_s, double gravity_mps2);

/// U10, m/s, of a sea that may hold swell: the strongest wind that the waves above any frequency ask for by
/// wind_of_height_and_period_mps(). Of a wind sea alone that is its own wind, since leaving out its longest
/// waves takes more from Hs^2 than it takes from Tp^3. Of a mixed sea it is the wind of its steepest part.
double wind_of_spectrum_mps(const SeaSpectrum& spectrum);

/// Peak period, s, of a fully developed sea of this height: 2 pi (5 m0 / (alpha g^2))^(1/4) with alpha =
/// 0.0081 (Pierson and Moskowitz 1964). On Earth it is 5.0 sqrt(Hs).
double developed_peak_period_s(double hs_m, double gravity_mps2);

}  // namespace offing::ocean
