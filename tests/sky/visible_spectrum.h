#pragma once

#include <array>
#include <cmath>

#include "host/sky/atmosphere.h"

namespace offing::sky {

/// Measured spectra in bins of 10 nm, 360 ... 830 nm, each the mean over its bin.
inline constexpr double first_bin_middle_nm = 365.0;
inline constexpr std::size_t bin_count = 48;

/// The sun above the air, W/m2/nm: ASTM G-173, extraterrestrial.
inline constexpr std::array<double, bin_count> sun_wpm2_nm{
    1.11776, 1.14259, 1.01249, 1.14716, 1.72765, 1.73054, 1.6887,  1.61253, 1.91198, 2.03474,
    2.02042, 2.02212, 1.93377, 1.95809, 1.91686, 1.8298,  1.8685,  1.8931,  1.85149, 1.8504,
    1.8341,  1.8345,  1.8147,  1.78158, 1.7533,  1.6965,  1.68194, 1.64654, 1.6048,  1.52143,
    1.55622, 1.5113,  1.474,   1.4482,  1.41018, 1.36775, 1.34188, 1.31429, 1.28303, 1.26758,
    1.2367,  1.2082,  1.18737, 1.14683, 1.12362, 1.1058,  1.07124, 1.04992};

/// Absorption cross-section of ozone at 233 K, 1e-26 m2: Serdyuchenko et al. 2014.
inline constexpr std::array<double, bin_count> ozone_1e26_m2{
    0.118, 0.02182, 0.02818, 0.06636, 0.1527, 0.2763, 0.552, 0.8451, 1.582, 2.316, 3.669, 4.924,
    7.752, 9.016,   14.8,    16.02,   21.39,  27.55,  30.91, 35.0,   42.66, 46.72, 43.98, 47.01,
    50.19, 43.05,   37.4,    32.15,   26.62,  22.38,  18.52, 14.73,  12.09, 9.423, 7.455, 6.566,
    5.105, 4.15,    4.228,   3.237,   2.451,  2.801,  2.534, 1.624,  1.465, 2.078, 1.383, 0.7105};

/// Molecules above a square metre in 300 Dobson units.
inline constexpr double ozone_column_pm2 = 300.0 * 2.687e20;

/// Bodhaine et al. 1999, eq. 30: the whole dry air at 1013.25 hPa, 45 degrees north.
inline double rayleigh_optical_depth(double wavelength_nm) {
  const double l2 = wavelength_nm * wavelength_nm * 1e-6;
  return 0.0021520 * (1.0455996 - 341.29061 / l2 - 0.90230850 * l2) /
         (1.0 + 0.0027059889 / l2 - 85.968563 * l2);
}

/// Linear interpolation between the middles of the bins.
double at_wavelength(const std::array<double, bin_count>& bins, double wavelength_nm);

/// Linear Rec.709, klx per W/m2: colour matching functions of Wyman, Sloan & Shirley 2013 (multi-lobe fit to
/// CIE 1931), matrix of IEC 61966-2-1.
Rgb rgb_of_wavelength(double wavelength_nm);

}  // namespace offing::sky
