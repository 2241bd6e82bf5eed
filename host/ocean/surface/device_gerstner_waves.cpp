// Phases and rings, reduced to what floats hold.
#include "host/ocean/surface/device_gerstner_waves.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "host/ocean/spectrum/dispersion.h"

namespace offing::ocean {
namespace {

constexpr float smallest_ring_m = 1e-6f;

}  // namespace

std::uint32_t device_turns(double turns) {
  const double fraction = turns - std::floor(turns);
  return static_cast<std::uint32_t>(std::llround(fraction * 4294967296.0));
}

/// A crest keeps the phase k r - omega t; seen from the ring, which moves at the group speed, that is
/// k u + (k c_g - omega) t.
GerstnerRing device_ring(const Raindrop& drop, double time_s, const Dispersion& dispersion,
                         const WaterPoint& origin) {
  const double age_s = std::max(time_s - drop.time_s, 0.0);
  const double fallen_m = time_s < drop.time_s ? 0.0 : drop.amplitude_m;
  const double k = two_pi / drop.wavelength_m;
  const double ring_radius_m = dispersion.group_speed_mps(k) * age_s;
  const double turns =
      ring_radius_m / drop.wavelength_m - std::fmod(dispersion.omega_radps(k) / two_pi * age_s, 1.0);
  return {.centre_x_m = static_cast<float>(drop.x_m - origin.x_m),
          .centre_z_m = static_cast<float>(drop.z_m - origin.z_m),
          .wavelength_m = static_cast<float>(drop.wavelength_m),
          .ring_radius_m = static_cast<float>(ring_radius_m),
          .amplitude_m = static_cast<float>(fallen_m * std::exp(-age_s / drop.decay_s)),
          .phase = std::bit_cast<std::int32_t>(device_turns(turns))};
}

bool is_visible(const GerstnerRing& ring) {
  return std::abs(ring.amplitude_m) > smallest_ring_m;
}

}  // namespace offing::ocean
