#pragma once

#include <optional>

namespace offing::ocean {

/// Foam from folding crests. Crests cover c(J) = clamp((onset_jacobian - J) / width, 0, 1), with J of O7 in
/// docs/sources.md, of the waves that are long enough to foam. J is computed at instants that are step_s
/// apart; t_q is the last one before time t. Foam at t is the largest of
///   c(J(t_q - j step_s)) exp(-(t - t_q + j step_s) / decay_s)  for past instants j of four decay times, and
///   c(J(t_q + step_s)) (t - t_q) / step_s, which fades in so that foam never jumps.
///
/// Foam of a cascade depends on its own J. Foam of the sea is 1 - product of (1 - foam) over its cascades. On
/// average foam of the sea covers `fraction` of it, with and without Gerstner waves (foam_onset.h).
struct FoamParameters {
  /// Share of the sea that foam covers on average; absent: no foam. A scene sets whitecap_fraction().
  std::optional<double> fraction = {};
  std::optional<double> onset_jacobian = {};  ///< J at which foam begins; absent: from `fraction`
  std::optional<double> width = {};  ///< J below the onset at which coverage is full; absent: foam_onset()
  double min_wavelength_m = 2.0;     ///< shorter waves draw in no air when they break
  double decay_s = 2.0;              ///< time for foam to fade by 1/e
  double step_s = 0.25;              ///< time between the instants
};

}  // namespace offing::ocean
