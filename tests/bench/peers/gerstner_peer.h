// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/sample_grid.h"
#include "tests/bench/huge_array.h"
#include "tests/bench/peers/gerstner_peer_kernels.h"

namespace offing::bench {

/// The maps of ocean::GerstnerSurface as others would write them in C++, on all cores with OpenMP: grids of a
/// multiple of 64 columns, 64 waves at most, none of them faded.
class GerstnerPeer {
 public:
  enum class Way {
    loop_64,     ///< a loop over columns with the compiler's vector mathematics (libmvec), 64 at a time
    loop_256,    ///< or 256
    recurrence,  ///< by hand in vectors of sixteen, waves turned from one to the next
    mirrored,    ///< by hand, columns mirrored about the middle of a block, as ours are
  };
  static std::string_view way_name(Way way);

  GerstnerPeer(const ocean::GerstnerSea& sea, const ocean::SampleGrid& grid);

  /// The maps at this time.
  void at(double time_s, Way way);

  /// [rows][columns] float4: dx, h, dz, d dx/dz.
  const HugeArray& displacement() const { return displacement_; }
  /// [rows][columns] float4: dh/dx, dh/dz, d dx/dx, d dz/dz.
  const HugeArray& gradient() const { return gradient_; }

 private:
  ocean::SampleGrid grid_;
  std::vector<peer::GerstnerWave> waves_;
  // In the middle of the first row at time 0; from row to row.
  std::vector<double> phase_rad_, row_step_rad_, omega_radps_;
  HugeArray displacement_, gradient_;
};

}  // namespace offing::bench
