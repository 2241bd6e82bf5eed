#pragma once

namespace offing::ocean {

/// U10, m/s, of the wind that raises a sea of this significant height and peak period, by the growth laws of
/// Hasselmann et al. 1973 over fetch X: with m0 = Hs^2 / 16 and x = g X / U^2,
///   m0 g^2 / U^4 = 1.6e-7 x   and   omega_peak U / g = 22 x^(-1/3).
/// Without x, U = m0 omega_peak^3 / (1.6e-7 22^3 g): the square of the height over the cube of the period. A
/// swell, which no wind here has made, comes out near 0. Kept within 0.1 ... 100 m/s.
double wind_of_height_and_period_mps(double hs_m, double peak_period_s, double gravity_mps2);

/// Peak period, s, of a fully developed sea of this height: 2 pi (5 m0 / (alpha g^2))^(1/4) with alpha =
/// 0.0081 (Pierson and Moskowitz 1964); 5.0 sqrt(Hs) in our gravity.
double developed_peak_period_s(double hs_m, double gravity_mps2);

}  // namespace offing::ocean
