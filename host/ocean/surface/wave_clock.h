#pragma once

#include <cstdint>
#include <optional>

namespace offing::ocean {

/// A time as kernels/ocean/wave_phase.clh reads it.
struct WaveTime {
  std::uint32_t ticks = 0;
  float tick_fraction = 0.0f;  ///< [0, 1)
};

/// The clock by which waves keep their phases.
///
/// Frequencies are whole numbers of cycles per 2^32 ticks. Without a loop there are 32 ticks a second, so
/// that the resolution is 7.5e-9 Hz and phases are exact for years; in a sea with faster waves, ripples of a
/// few millimetres on a small patch, the next power of two above the fastest wave's frequency, with a
/// resolution of 4.7e-10 of that frequency or finer. With a loop period T, 2^32 ticks are T, so that every
/// wave repeats exactly after T.
class WaveClock {
 public:
  /// For waves up to this frequency.
  WaveClock(double highest_hz, std::optional<double> loop_period_s);

  WaveTime at(double time_s) const;
  /// Angular frequency, rad/s, of rate 1.
  double radps_per_rate() const;
  /// Cycles per 2^32 ticks of a wave: the nearest whole number, in a loop one at least, so that none stands
  /// still there.
  std::uint32_t rate(double omega_radps) const;

 private:
  std::optional<double> loop_period_s_;
  double ticks_per_second_;  // unused in a loop
};

}  // namespace offing::ocean
