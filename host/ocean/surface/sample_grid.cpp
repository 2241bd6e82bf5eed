// The limits of a grid that seas are evaluated on.
#include "host/ocean/surface/sample_grid.h"

#include "host/base/parameter_check.h"

namespace offing::ocean {

void require_valid_grid(const SampleGrid& grid) {
  require_within("sample grid columns", grid.columns, 1, 16384);
  require_within("sample grid rows", grid.rows, 1, 16384);
  for (const double origin_m : {grid.origin_x_m, grid.origin_z_m})
    require_within("sample grid origin_m", origin_m, -1e9, 1e9);
  for (const double spacing_m : {grid.spacing_x_m, grid.spacing_z_m})
    require_within("sample grid spacing_m", spacing_m, -1e6, 1e6);
}

}  // namespace offing::ocean
