#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace offing {

/// One wave of a sea. With p = kx x + kz z - omega t + phase the water that is at (x, z) at rest, +x east and
/// +z south, rises to A cos p. The wave travels toward (kx, kz).
struct SeaMode {
  static constexpr int alone = -1;

  double amplitude_m = 0.0;
  double kx_radpm = 0.0, kz_radpm = 0.0;
  double omega_radps = 0.0;
  double phase_rad = 0.0;
  /// The patch whose lattice it lies on, an index into ModalSea::patch_lengths_m; `alone` for none.
  int patch = alone;
};

/// A sea as a sum of waves, which another program can evaluate: at rest at X, water moves sideways by
/// -choppiness K/k A sin p. Waves on lattices come from Fourier transforms of square patches, which repeat;
/// those alone do not. Made by ocean::Ocean and host/io readers, consumed by ocean::Ocean.
struct ModalSea {
  std::vector<SeaMode> modes = {};
  std::vector<double> patch_lengths_m = {};  ///< from long to short, none twice
  /// n: along each axis modes of a patch are at whole multiples of 2 pi / length, up to n/2 - 1.
  int size = 16;
  double split_radpm = 0.0;  ///< modes of patches are no longer than this
  double choppiness = 1.0;
  double depth_m = std::numeric_limits<double>::infinity();
  std::optional<double> loop_period_s = {};  ///< all repeats after this time
};

}  // namespace offing
