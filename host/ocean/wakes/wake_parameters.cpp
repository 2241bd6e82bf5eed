#include "host/ocean/wakes/wake_parameters.h"

#include <numbers>

#include "host/ocean/ocean_limits.h"
#include "kernels/shared/wake.h"

namespace offing::ocean {

double WakeHull::displaced_volume_m3() const {
  const double box_m3 = 0.25 * length_m * beam_m * draught_m * std::numbers::pi;
  return shape == Shape::gaussian ? box_m3 : 2.0 / 3.0 * box_m3;
}

void require_valid_wake(const WakeParameters& parameters) {
  require_valid_size(parameters.cells);
  require_within("wake.length_m", parameters.length_m, 0.1, 1e5);
  require_within("wake.step_s", parameters.step_s, 1e-4, 1.0);
  require_valid_dispersion(parameters.dispersion);
  require_within("wake.speed_mps", parameters.speed_mps, 0.01, 100.0);
  const double square_m = WAKE_RAIN_SQUARE * parameters.cell_m();
  require_within("wake.rain.drops_per_m2s", parameters.rain.drops_per_m2s, 0.0,
                 1.0 / (square_m * square_m * parameters.step_s));
  require_within("wake.rain.hollow_m", parameters.rain.hollow_m, -1.0, 1.0);
}

}  // namespace offing::ocean
