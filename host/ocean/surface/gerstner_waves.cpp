#include "host/ocean/surface/gerstner_waves.h"

#include <algorithm>

#include "host/base/parameter_check.h"
#include "host/ocean/ocean_limits.h"
#include "kernels/shared/gerstner_params.h"

namespace offing::ocean {
namespace {

constexpr double largest_angle_rad = 1e6;
constexpr double largest_amplitude_m = 100.0;
constexpr double shortest_wavelength_m = 0.1, longest_wavelength_m = 1e5;
constexpr double largest_place_m = 1e9;

}  // namespace

GerstnerWave make_swell(const Swell& swell, const Dispersion& dispersion) {
  require_valid_dispersion(dispersion);
  require_within("swell.amplitude_m", swell.amplitude_m, 0.0, largest_amplitude_m);
  require_within("swell.wavelength_m", swell.wavelength_m, shortest_wavelength_m, longest_wavelength_m);
  require_within("swell.direction_rad", swell.direction_rad, -largest_angle_rad, largest_angle_rad);
  require_within("swell.phase_rad", swell.phase_rad, -largest_angle_rad, largest_angle_rad);
  const double wavenumber_radpm = two_pi / swell.wavelength_m;
  return {.amplitude_m = swell.amplitude_m,
          .wavenumber_radpm = wavenumber_radpm,
          .direction_rad = swell.direction_rad,
          .omega_radps = dispersion.omega_radps(wavenumber_radpm),
          .phase_rad = swell.phase_rad};
}

HorizontalScale horizontal_scale(const GerstnerSea& sea) {
  double steepness = 0.0;
  for (const GerstnerWave& wave : sea.waves) steepness += wave.wavenumber_radpm * wave.amplitude_m;
  const bool is_limited = sea.choppiness * steepness > 1.0;
  return {.scale = is_limited ? 1.0 / steepness : sea.choppiness,
          .steepness = steepness,
          .is_limited = is_limited};
}

double largest_wavenumber_radpm(double min_wavelength_m) {
  constexpr double rounding = 1.0 + 1e-6;
  return two_pi / min_wavelength_m * rounding;
}

void require_valid_gerstner_waves(const GerstnerSea& sea) {
  require_within("gerstner wave count", static_cast<double>(sea.waves.size()), 0, GERSTNER_WAVES);
  require_within("raindrop count", static_cast<double>(sea.raindrops.size()), 0, 4096);
  require_within("choppiness", sea.choppiness, 0.0, 10.0);
  if (sea.loop_period_s) require_within("loop_period_s", *sea.loop_period_s, 0.1, 1e5);
  require_valid_dispersion(sea.dispersion);
  for (const GerstnerWave& wave : sea.waves) {
    require_within("gerstner.amplitude_m", wave.amplitude_m, 0.0, largest_amplitude_m);
    require_within("gerstner.wavenumber_radpm", wave.wavenumber_radpm, two_pi / longest_wavelength_m / 10.0,
                   two_pi / shortest_wavelength_m * (1.0 + 1e-12));
    require_within("gerstner.direction_rad", wave.direction_rad, -largest_angle_rad, largest_angle_rad);
    require_within("gerstner.omega_radps", wave.omega_radps, 0.0, largest_omega_radps);
    require_within("gerstner.phase_rad", wave.phase_rad, -largest_angle_rad, largest_angle_rad);
  }
  for (const Raindrop& drop : sea.raindrops) {
    require_within("raindrop.x_m", drop.x_m, -largest_place_m, largest_place_m);
    require_within("raindrop.z_m", drop.z_m, -largest_place_m, largest_place_m);
    require_within("raindrop.time_s", drop.time_s, -largest_time_s, largest_time_s);
    require_within("raindrop.amplitude_m", drop.amplitude_m, -largest_amplitude_m, largest_amplitude_m);
    require_within("raindrop.wavelength_m", drop.wavelength_m, 1e-3, longest_wavelength_m);
    require_within("raindrop.decay_s", drop.decay_s, 1e-3, 1e5);
  }
}

}  // namespace offing::ocean
