#include "host/ocean/drawn_trochoids.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "host/ocean/parameter_check.h"
#include "host/ocean/wave_clock.h"

namespace offing::ocean {

std::vector<DrawnTrochoid> draw_trochoids(const TrochoidSea& sea, glm::dvec2 label_m, double time_s) {
  constexpr double two_pi = 2.0 * std::numbers::pi;
  constexpr double all_ticks = 4294967296.0;  // 2^32
  require_valid_trochoids(sea);
  require_within("time_s", time_s, -1e8, 1e8);
  const WaveClock clock(largest_omega_radps / two_pi, sea.loop_period_s);
  const WaveTime time = clock.at(time_s);
  const double scale = horizontal_scale(sea).scale;
  std::vector<DrawnTrochoid> drawn;
  for (const Trochoid& wave : sea.waves) {
    const double k = wave.wavenumber_radpm;
    const glm::dvec2 wave_radpm(k * std::cos(wave.direction_rad), k * std::sin(wave.direction_rad));
    const std::uint32_t rate = clock.rate(wave.omega_radps);
    // Whole ticks modulo a turn in integers, as the device has them.
    const std::uint32_t whole_ticks = rate * time.ticks;
    const double ticks = whole_ticks + static_cast<double>(rate) * time.tick_fraction;
    const double place_turns = (wave_radpm.x * label_m.x + wave_radpm.y * label_m.y) / two_pi;
    const double turns = place_turns - ticks / all_ticks + wave.phase_rad / two_pi;
    drawn.push_back({.wave_radpm = wave_radpm,
                     .amplitude_m = wave.amplitude_m,
                     .shift_m = scale * wave.amplitude_m,
                     .phase_rad = two_pi * (turns - std::floor(turns))});
  }
  return drawn;
}

}  // namespace offing::ocean
