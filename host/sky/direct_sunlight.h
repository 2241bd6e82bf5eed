#pragma once

namespace offing::sky {

/// The sun's light at the mean distance of the Earth, outside the air, W/m^2 (Kopp & Lean 2011).
inline constexpr double solar_constant_w_per_m2 = 1361.0;
/// How many clean, dry atmospheres dim the sun as the air does (Linke): 2 in mountains, 3 in clear air over
/// land, 5 and more where it is hazy.
inline constexpr double usual_turbidity = 3.0;

/// The sun's direct light on a surface that faces it, under a clear sky, W/m^2: Ineichen & Perez 2002, A new
/// airmass independent formulation for the Linke turbidity coefficient, Solar Energy 73, with the correction
/// that pvlib names, the air mass of Kasten & Young 1989 and the pressure of the standard atmosphere at this
/// height. The elevation is that of the middle of the disc, lifted by refraction; 0 at the horizon and below.
double direct_sunlight_w_per_m2(double elevation_rad, double height_m, double distance_au,
                                double linke_turbidity);

}  // namespace offing::sky
