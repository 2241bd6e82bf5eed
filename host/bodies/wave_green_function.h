// The potential of a source that pulsates below the surface of deep water.
#pragma once

namespace offing::bodies {

/// The Green function of deep water for e^(-i omega t), with nu = omega^2 / g (Newman 1985):
///   G = 1/r + 1/r' + nu F(X, Y) + 2 pi i nu e^-Y J0(X),  X = nu R,  Y = -nu (y + eta) >= 0,
/// where R is the horizontal distance, y and eta the heights of the two points over the still water, r' the
/// distance to the mirror image of one, and
///   F = -2 e^-Y integral_0^Y e^t / sqrt(X^2 + t^2) dt - pi e^-Y (H0(X) + Y0(X)),  H0 Struve's function.
/// dF/dY = -F - 2 / sqrt(X^2 + Y^2).
struct WavePart {
  double f;         ///< F
  double f_x;       ///< dF/dX
  double decay_j0;  ///< e^-Y J0(X)
  double decay_j1;  ///< e^-Y J1(X)
};

/// F and dF/dX less their singular parts are looked up in a table that the first call makes, and are
/// asymptotic series far away. The errors of f and f_x are at most 1e-5 (1 + 1 / sqrt(X^2 + Y^2)). X and Y
/// must not both be 0.
WavePart wave_part(double x, double y);

}  // namespace offing::bodies
