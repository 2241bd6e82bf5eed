// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/ocean/surface/wave_modes.h"
#include "tests/bench/huge_array.h"
#include "tests/bench/peers/fftw_plan.h"
#include "tests/bench/peers/ocean_peer_kernels.h"

namespace offing::bench {

/// The frame of ocean::SurfaceMaps for one cascade, as a specialist would write it in C++ with FFTW: modes of
/// half the plane, vectorised, two real fields a complex transform, four transforms, two maps of four fields.
class OceanPeer {
 public:
  /// Fields of this cascade of `modes`, on all cores. Plans every way to do it.
  OceanPeer(const ocean::WaveModes& modes, int cascade, float choppiness);

  /// The ways differ in the padding of rows, in whether cores share a transform or take one each, and in how
  /// maps are stored.
  std::size_t way_count() const { return ways_.size(); }
  std::string way_name(std::size_t way_index) const;

  /// The frame at this time.
  void at(const ocean::WaveTime& time, std::size_t way_index);

  /// [n][n] float4: dx, h, dz, d dx/dz.
  const HugeArray& displacement() const { return displacement_; }
  /// [n][n] float4: dh/dx, dh/dz, d dx/dx, d dz/dz.
  const HugeArray& gradient() const { return gradient_; }

 private:
  void read_modes(const ocean::WaveModes& modes, int cascade);
  enum class Cores { share_transforms, take_one_each };
  struct Way {
    FftwPlan plan;
    int pitch;
    Cores cores;
    peer::Stores stores;
  };

  void evolve(const ocean::WaveTime& time, int row, int pitch);
  void pack(int row, const Way& way);
  std::size_t field_floats(int pitch) const;

  int size_;
  int mode_rows_;
  float choppiness_;
  float wavenumber_step_radpm_;
  HugeArray amplitude_;  // [4][mode_rows][n] m: P and Q of the rows with kz >= 0, real and imaginary
  std::vector<std::uint32_t> rate_;
  HugeArray spectra_;  // [4][n][pitch] complex
  HugeArray displacement_, gradient_;
  std::vector<Way> ways_;
};

}  // namespace offing::bench
