#pragma once

#include <array>

#include "kernels/shared/atmosphere_params.h"

namespace offing::sky {

/// Red, green, blue of light, linear Rec.709.
using Rgb = std::array<double, 3>;

/// A value at each wavelength at which light is carried through the air: 626, 564, 512, 440 nm. With four of
/// them and the sums of rgb_of_sunlight(), chosen together by least squares, light that air and ozone have
/// reddened or blued comes within 1 % of its luminance of the colour of all visible wavelengths
/// (tests/sky/atmosphere_test.cpp); the customary three, one a primary, double the red of a twilight sky.
using Spectrum = std::array<double, 4>;
inline constexpr Spectrum wavelengths_nm{626.0, 564.0, 512.0, 440.0};

/// A clear, round atmosphere over a ground of one colour. Its layers are those of Bruneton 2017,
/// "Precomputed atmospheric scattering: a new implementation", also used by Hillaire 2020; its amounts are
/// measured ones.
struct Atmosphere {
  double ground_radius_m = 6'360'000.0;
  double thickness_m = 100'000.0;  ///< altitude where the air ends

  /// Straight up from the sea at 1013.25 hPa: Bodhaine et al. 1999, eq. 30.
  Spectrum rayleigh_optical_depth{0.057301, 0.087604, 0.130076, 0.242605};
  double rayleigh_scale_height_m = 8000.0;

  /// Clean sea air: 0.06 (Smirnov et al. 2009), taken alike at all wavelengths.
  double aerosol_optical_depth = 0.06;
  double aerosol_scale_height_m = 1200.0;
  double aerosol_albedo = 0.97;    ///< share of extinction that is scattering: Dubovik et al. 2002, Lanai
  double aerosol_asymmetry = 0.8;  ///< g of the Cornette-Shanks phase function, forward positive

  /// Straight up, 300 Dobson units: cross-sections of Serdyuchenko et al. 2014 at 233 K, means of 10 nm.
  Spectrum ozone_optical_depth{0.029725, 0.033771, 0.012619, 0.000978};
  double ozone_peak_m = 25'000.0;  ///< of its layer, a tent
  double ozone_half_width_m = 15'000.0;

  /// Of the sea, diffuse: 0.04 that its surface reflects of light from a high sun, and the blue that clear
  /// water sends back (about half of its irradiance reflectance at 0.1 mg/m3 of chlorophyll, Morel &
  /// Maritorena 2001).
  Spectrum ground_albedo{0.042, 0.047, 0.055, 0.065};

  double sun_angular_radius_rad = 0.00465;  ///< 16 minutes of arc: 6.8e-5 sr

  bool operator==(const Atmosphere&) const = default;
};

/// Throws Error(bad_input) that names the first parameter out of range.
void require_valid(const Atmosphere& atmosphere);

/// What the kernels read of it.
AtmosphereParams atmosphere_params(const Atmosphere& atmosphere);

/// Linear Rec.709, klx, that all sunlight above the air at 1 au has by each wavelength's share: colour and
/// luminance of light are sums over the four. Made from the sun's spectrum of ASTM G-173 (10 nm) and the
/// colour matching functions of Wyman et al. 2013; negative where a wavelength lies outside Rec.709.
struct SunlightColour {
  Spectrum red_klx{132.6653, 72.3083, -69.7309, 10.1406};
  Spectrum green_klx{-4.6938, 75.7197, 70.2797, -10.8708};
  Spectrum blue_klx{0.5478, -26.9376, 42.9662, 108.1253};
};

/// Linear Rec.709, klx, of sunlight of which these shares are left.
Rgb rgb_of_sunlight(const Spectrum& share);

/// Luminance of linear Rec.709, in the unit of its channels.
double luminance(const Rgb& light);

}  // namespace offing::sky
