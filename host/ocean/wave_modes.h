#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/ocean/cascades.h"
#include "host/ocean/sea_spectrum.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"

namespace offing::ocean {

/// A time as kernels/ocean/wave_phase.clh reads it.
struct WaveClock {
  std::uint32_t ticks = 0;
  float tick_fraction = 0.0f;  ///< [0, 1)
};

/// The random modes of every cascade on the device: what a sea is before a time is chosen.
///
/// Frequencies are whole numbers of cycles per 2^32 ticks. Without a loop there are 32 ticks a second, so
/// that the resolution is 7.5e-9 Hz and phases are exact for years; in a sea with faster waves, ripples of a
/// few millimetres on a small patch, the next power of two above the fastest wave's frequency, with a
/// resolution of 4.7e-10 of that frequency or finer. With a loop period T, 2^32 ticks are T, so that every
/// wave repeats exactly after T.
class WaveModes {
 public:
  /// Throws Error(bad_input) if the fastest wave makes more than 2^22 cycles in the loop: its phase would
  /// move in steps of more than 2^-6 turns.
  WaveModes(const ocl::Device& device, const SeaSpectrum& spectrum, std::span<const Cascade> cascades,
            int size, std::optional<double> loop_period_s);

  /// Draws the amplitudes of this seed.
  void draw(std::uint64_t seed);

  int size() const { return size_; }
  int cascade_count() const { return static_cast<int>(cascades_.size()); }
  /// Columns of the amplitude and rate arrays: kx = 0 ... n/2 - 1, padded to a whole strip of 16.
  int columns() const { return columns_; }

  WaveClock clock(double time_s) const;
  /// Angular frequency, rad/s, of rate 1.
  double radps_per_rate() const;

  /// [cascades][4][columns/16][n][16] m: P and Q, real and imaginary (kernels/ocean/spectrum_initial.cl).
  const ocl::Buffer<float>& amplitude() const { return amplitude_; }
  /// [cascades][columns/16][n][16] cycles per 2^32 ticks.
  const ocl::Buffer<std::uint32_t>& rate() const { return rate_; }
  /// [cascades] 2 pi / L, rad/m.
  const ocl::Buffer<float>& wavenumber_step() const { return wavenumber_step_; }
  /// Expected variance of each mode of one cascade, [n][n] m^2, K = 0 at [0][0].
  std::vector<float> variance(int cascade) const;

 private:
  std::vector<std::uint32_t> rates(const Dispersion& dispersion) const;

  ocl::Device device_;
  std::vector<Cascade> cascades_;
  int size_;
  int columns_;
  std::optional<double> loop_period_s_;
  double ticks_per_second_;  // unused in a loop
  ocl::Kernel initial_;
  std::vector<ocl::Buffer<float>> variance_;  // a cascade each
  ocl::Buffer<float> amplitude_;
  ocl::Buffer<std::uint32_t> rate_;
  ocl::Buffer<float> wavenumber_step_;
};

}  // namespace offing::ocean
