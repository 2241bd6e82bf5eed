#pragma once

#include <optional>
#include <vector>

#include "host/ocean/spectrum/dispersion.h"

namespace offing::ocean {

/// Waves of 0.1 m, in stronger gravity than ours and with surface tension, stay below it: 32 Hz.
inline constexpr double largest_omega_radps = 200.0;

/// One Gerstner wave (O8 of docs/sources.md). With p = K . X - omega t + phase, a point at rest at label X
/// rises to h = A cos p and moves by -Q A K/k sin p, which sharpens crests as the cascades' choppiness does.
/// The mean of h over labels is 0; over space, where crests are narrower, it is -1/2 Q sum of k A^2.
struct GerstnerWave {
  double amplitude_m = 0.0;
  double wavenumber_radpm = 0.0;
  double direction_rad = 0.0;  ///< of travel
  double omega_radps = 0.0;
  double phase_rad = 0.0;  ///< at label (0, 0) and time 0
};

/// A parallel swell as a user asks for it.
struct Swell {
  double amplitude_m = 0.5;
  double wavelength_m = 100.0;
  double direction_rad = 0.0;
  double phase_rad = 0.0;
};

/// A ring of waves that a drop sets off at a point. It moves outward at the group speed of its wavelength,
/// about four wavelengths wide, and loses height as 1/sqrt(radius) and as exp(-time / decay). It moves the
/// surface up and down only, so that no drop changes how far the sea elsewhere may lean.
struct Raindrop {
  double x_m = 0.0, z_m = 0.0;  ///< label of the centre
  double time_s = 0.0;          ///< when it falls; nothing moves before
  double amplitude_m = 0.01;    ///< at the centre, at that time; negative for a hollow
  double wavelength_m = 0.2;
  double decay_s = 1.0;
};

/// All Gerstner waves of a sea. Plain data: waves and drops may come, change and go from frame to frame.
struct GerstnerSea {
  std::vector<GerstnerWave> waves = {};  ///< those of choose_gerstner_waves() and swells, 128 at most
  std::vector<Raindrop> raindrops = {};
  double choppiness = 1.0;  ///< that of the cascades, O7
  /// Frequencies become whole numbers of cycles in this time, at least one, as those of the cascades do, so
  /// that all waves repeat exactly after it. Raindrops fall once.
  std::optional<double> loop_period_s = {};
  Dispersion dispersion = {};  ///< of the raindrops' waves
};

/// The wave that a user's swell is in water of this dispersion. Throws Error(bad_input) for an amplitude
/// beyond 0 ... 100 m, a wavelength beyond 0.1 m ... 100 km, or angles that are not finite.
GerstnerWave make_swell(const Swell& swell, const Dispersion& dispersion);

/// How far the Gerstner waves of a sea may move sideways.
struct HorizontalScale {
  double scale = 0.0;       ///< Q
  double steepness = 0.0;   ///< sum of k A
  bool is_limited = false;  ///< Q is below the choppiness that was asked for: worth telling the user
};

/// Q = min(choppiness, 1 / sum of k A): the surface of the Gerstner waves alone then never folds, whatever
/// their phases. Amplitudes stay as they are.
HorizontalScale horizontal_scale(const GerstnerSea& sea);

/// The largest wavenumber of waves that are no shorter than this, rad/m, with room for rounding; infinite for
/// 0.
double largest_wavenumber_radpm(double min_wavelength_m);

/// Throws Error(bad_input) that names what is out of range: more than 128 waves or 4096 raindrops, a wave or
/// drop that is not finite or has no length, a choppiness beyond 0 ... 10, a loop beyond 0.1 ... 1e5 s.
void require_valid_gerstner_waves(const GerstnerSea& sea);

}  // namespace offing::ocean
