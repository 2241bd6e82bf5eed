#pragma once

namespace offing::ocean {

/// A rectangle of rest labels to evaluate a sea at.
struct SampleGrid {
  double origin_x_m = 0.0, origin_z_m = 0.0;    ///< label of the first sample
  double spacing_x_m = 1.0, spacing_z_m = 1.0;  ///< between columns, rows
  int columns = 0, rows = 0;
};

/// Throws Error(bad_input) for a grid without samples, of more than 16384 a side, or not finite.
void require_valid_grid(const SampleGrid& grid);

}  // namespace offing::ocean
