#pragma once

#include <span>
#include <vector>

#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/gerstner_waves.h"

namespace offing::ocean {

/// What reading a wave of whole cycles along n samples makes of it, for 0, 1, ... cycles, along one axis. A
/// sum of waves between samples has each wave times a gain, and its aliases.
struct AxisResponse {
  std::vector<double> filter;  ///< by which the samples are multiplied in advance
  std::vector<double> gain;    ///< of the wave itself
  std::vector<double> power;   ///< of the wave and its aliases together, 1 for what is exact
  /// Mean square of the derivative of both, in cycles along the n samples: cycles squared for what is exact.
  std::vector<double> slope_power;
};

/// Of splines of this order, with the filter of least mean square error, for waves that are 0 elsewhere:
/// filter S_0 / Q, S_m = sinc^order(cycles/n + m), Q the sum of S_m^2 over all aliases m (the response of
/// B-splines: Unser 1999, Splines; least squares: Jacob 2002, for transforms to places between samples).
AxisResponse spline_response(int order, int n, int cycles);
/// Of straight lines between samples, without a filter.
AxisResponse linear_response(int n, int cycles);
/// Of sums over all waves.
AxisResponse exact_response(int cycles);

/// Expected mean squares of a sea's errors at labels, from its spectrum, with rounding to single precision.
struct LabelError {
  double height_m2 = 0.0;
  double shift_x_m2 = 0.0, shift_z_m2 = 0.0;  ///< of the horizontal displacement
  double slope_x2 = 0.0, slope_z2 = 0.0;      ///< mean squares of the slopes themselves

  LabelError& operator+=(const LabelError& other);
  /// Of heights at points: a label that is missed sideways has another height, by the surface's slope.
  double height_rms_m() const;
};

/// Of one cascade: variance [n][n] m^2 of its modes, K = 0 at [0][0], as far as they count. `shifts_alike`:
/// displacements are read as heights are, not as derivatives.
LabelError cascade_error(const Cascade& cascade, std::span<const float> variance, int size, double choppiness,
                         double min_wavelength_m, const AxisResponse& response, bool shifts_alike);

/// Gerstner waves are exact but for rounding.
LabelError gerstner_error(const GerstnerSea& sea, double min_wavelength_m);

}  // namespace offing::ocean
