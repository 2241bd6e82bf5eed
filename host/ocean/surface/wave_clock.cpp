#include "host/ocean/surface/wave_clock.h"

#include <algorithm>
#include <cmath>

#include "host/ocean/spectrum/dispersion.h"

namespace offing::ocean {
namespace {

constexpr double usual_ticks_per_second = 32.0;  // all waves longer than a centimetre are slower than 32 Hz
constexpr double all_ticks = 4294967296.0;       // 2^32
constexpr double loop_instants = 268435456.0;    // 2^28: a loop of 100 s has one every 0.4 us
constexpr std::int64_t ticks_per_loop_instant = 16;  // 2^32 / 2^28

// Ticks for waves up to this frequency, which stay below one cycle a tick.
double ticks_per_second_for(double highest_hz) {
  double ticks = usual_ticks_per_second;
  while (ticks <= highest_hz) ticks *= 2.0;
  return ticks;
}

}  // namespace

WaveClock::WaveClock(double highest_hz, std::optional<double> loop_period_s)
    : loop_period_s_(loop_period_s), ticks_per_second_(ticks_per_second_for(highest_hz)) {}

WaveTime WaveClock::at(double time_s) const {
  if (loop_period_s_) {
    // t and t + T differ by rounding of either; the coarser the instants, the rarer it falls between two.
    const double instant = std::round(std::fmod(time_s, *loop_period_s_) / *loop_period_s_ * loop_instants);
    return {static_cast<std::uint32_t>(static_cast<std::int64_t>(instant) * ticks_per_loop_instant), 0.0f};
  }
  const double ticks = time_s * ticks_per_second_;
  const double whole = std::floor(ticks);
  return {static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)),
          std::min(static_cast<float>(ticks - whole), 0x1.fffffep-1f)};
}

double WaveClock::radps_per_rate() const {
  return loop_period_s_ ? two_pi / *loop_period_s_ : two_pi * ticks_per_second_ / all_ticks;
}

std::uint32_t WaveClock::rate(double omega_radps) const {
  const double cycles = loop_period_s_ ? std::max(1.0, std::round(omega_radps / two_pi * *loop_period_s_))
                                       : std::round(omega_radps / radps_per_rate());
  // One below a cycle a tick at most, also where rounding reaches it.
  return static_cast<std::uint32_t>(std::min(cycles, all_ticks - 1.0));
}

}  // namespace offing::ocean
