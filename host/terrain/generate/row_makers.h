#pragma once

#include <span>
#include <vector>

#include "host/terrain/generate/fractal_terrain.h"

namespace offing::terrain {

/// Rows of made ground, by all cores.
class RowMakers {
 public:
  /// Throws what require_valid() throws.
  explicit RowMakers(const FractalParameters& parameters);

  int rows_at_once() const { return rows_a_maker * static_cast<int>(makers_.size()); }

  /// Heights [rows][posts] m of the rows from `first` on, as many as are made at once or are left; valid
  /// until the next call.
  std::span<const float> make(int first);

 private:
  static constexpr int rows_a_maker = 16;
  int posts_;
  std::vector<FractalTerrain> makers_;
  std::vector<float> heights_m_;
};

}  // namespace offing::terrain
