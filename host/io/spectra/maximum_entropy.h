#pragma once

#include <complex>
#include <span>

namespace offing::spectra {

/// Directions that spreading made from moments is tabulated at: theta_j = 2 pi j / 120, every 3 degrees.
/// Averaging over cells that wide and undoing its effect on the moments leaves them within 1e-3 for all
/// moments that a sea can have (every 5 degrees: 2e-3), and a record of 47 frequencies takes 45 kB.
inline constexpr int direction_count = 120;

/// One row of D(f, theta), 1/rad, at theta_j: >= 0, sum times 2 pi / 120 is 1.
using SpreadingRow = std::span<double, direction_count>;

/// First circular moments of a spreading function, c_n = integral of D(theta) e^(i n theta) d theta.
struct DirectionalMoments {
  std::complex<double> first;
  std::complex<double> second;
};

/// Largest |c1| kept: a spread sqrt(2 (1 - r1)) of 2 degrees, less than the table can show.
inline constexpr double largest_first_moment = 0.9994;

/// The nearest moments that a spreading function can have, and with which the table still resolves it. The
/// first moment is the better measured one and rules the mean direction, so it is kept and the second one
/// gives way:
///  1. |c1| is cut to largest_first_moment;
///  2. k2 = (c2 - c1^2) / (1 - |c1|^2), which must not exceed 1, is cut to |k2| <= 0.999;
///  3. k2 is reduced further while a peak narrower than the finest sampling would result.
/// Admissible moments that leave no such peak come back as they are.
DirectionalMoments admissible_moments(DirectionalMoments moments);

/// The spreading function of maximum entropy (in Burg's sense) with these moments:
///   D = (1 - p1 c1* - p2 c2*) / (2 pi |1 - p1 e^(-i theta) - p2 e^(-2 i theta)|^2),
///   p1 = (c1 - c2 c1*) / (1 - |c1|^2),  p2 = c2 - c1 p1        (Lygre & Krogstad 1986, eqs. 12 to 14).
/// It is never negative and each table value is a mean over the neighbouring cells, so that peaks of any
/// width integrate to 1. The table has the moments of admissible_moments(moments) to 1e-3.
void maximum_entropy_spreading(DirectionalMoments moments, SpreadingRow row);

/// D proportional to cos^(2s)((theta - theta_1) / 2) with this first moment, s = r1 / (1 - r1): for files
/// that give mean direction and spread alone. |c1| is cut to largest_first_moment. (Longuet-Higgins,
/// Cartwright, Smith 1963)
void cosine_power_spreading(std::complex<double> first_moment, SpreadingRow row);

}  // namespace offing::spectra
