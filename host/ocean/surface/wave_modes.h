#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "host/base/sea/modal_sea.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/wave_clock.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"

namespace offing::ocean {

/// The modes of every cascade on the device, random or given: what a sea is before a time is chosen.
class WaveModes {
 public:
  /// Throws Error(bad_input) if the fastest wave makes more than 2^22 cycles in the loop: its phase would
  /// move in steps of more than 2^-6 turns. With `given`, the waves of its patches take the place of random
  /// ones, and its variances that of the spectrum's; throws what place_modes() throws.
  WaveModes(const ocl::Device& device, const SeaSpectrum& spectrum, std::span<const Cascade> cascades,
            int size, std::optional<double> loop_period_s, const ModalSea* given = nullptr);

  /// Draws the amplitudes of this seed; given ones are the same for all.
  void draw(std::uint64_t seed);

  /// The waves as they are.
  std::vector<SeaMode> list() const;

  int size() const { return size_; }
  int cascade_count() const { return static_cast<int>(cascades_.size()); }
  /// Columns of the amplitude and rate arrays: kx = 0 ... n/2 - 1, padded to a whole strip of 16.
  int columns() const { return columns_; }

  /// By which the waves keep their phases.
  const WaveClock& clock() const { return clock_; }

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
  WaveClock clock_;
  ocl::Kernel initial_;
  std::vector<ocl::Buffer<float>> variance_;  // a cascade each
  ocl::Buffer<float> amplitude_;
  bool is_given_;
  ocl::Buffer<std::uint32_t> rate_;
  ocl::Buffer<float> wavenumber_step_;
};

}  // namespace offing::ocean
