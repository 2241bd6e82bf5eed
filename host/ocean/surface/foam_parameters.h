#pragma once

#include <optional>

namespace offing::ocean {

/// Foam from folding crests (J of O7 in docs/sources.md, of the waves that are long enough to foam): coverage
/// c(J) = clamp((onset_jacobian - J) / width, 0, 1). Its past instants lie step apart, t_q the last of them
/// before time t. Foam is the largest coverage of the last four decay times, decayed, with the next instant's
/// fading in, so that foam never jumps: max of c(J(t_q - j step)) exp(-(t - t_q + j step) / decay) over j and
/// of c(J(t_q + step)) (t - t_q) / step.
///
/// Foam of a cascade goes by this cascade's J. Foam of the sea is what any of its cascades makes: 1 - product
/// of (1 - foam). Both cover `fraction` of the sea on average, with and without Gerstner waves
/// (foam_onset.h).
struct FoamParameters {
  /// Share of the sea that foam covers on average; absent: none. A scene fills in whitecap_fraction().
  std::optional<double> fraction = {};
  std::optional<double> onset_jacobian = {};  ///< J at which foam begins; absent: from `fraction`
  std::optional<double> width = {};  ///< J below the onset at which coverage is full; absent: foam_onset()
  double min_wavelength_m = 2.0;     ///< shorter waves break without drawing air under
  double decay_s = 2.0;              ///< time for foam to fade by 1/e
  double step_s = 0.25;              ///< spacing of the past instants that are looked at
};

}  // namespace offing::ocean
