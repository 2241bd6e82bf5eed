#include "host/ocean/wakes/wake_border.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::ocean {
namespace {

constexpr double border_share = 0.125;
// e^-5 = 0.7 %: damping and reflection of the longest waves are alike then.
constexpr double attenuation = 5.0;

double group_speed_mps(const WakeParameters& parameters, double wavelength_m) {
  if (parameters.method == WakeMethod::verlet) return parameters.speed_mps;
  return parameters.dispersion.group_speed_mps(2.0 * std::numbers::pi / wavelength_m);
}

}  // namespace

double wake_border_m(const WakeParameters& parameters) {
  return border_share * parameters.length_m;
}

WakeBorder make_wake_border(const WakeParameters& parameters, double part_s) {
  const double width_m = wake_border_m(parameters);
  // The integral of (1 - u)^2 over both borders is 2/3 of a width.
  const double rate_per_s = 1.5 * attenuation * group_speed_mps(parameters, width_m) / width_m;
  WakeBorder border;
  for (int i = 0; i < parameters.cells; ++i) {
    const int from_edge = std::min(i, parameters.cells - 1 - i);
    const double u = std::min(1.0, (from_edge + 0.5) * parameters.cell_m() / width_m);
    border.kept.push_back(static_cast<float>(std::exp(-rate_per_s * (1.0 - u) * (1.0 - u) * part_s)));
    // Shown is what is left where the outer half of the border begins, faded by a smooth step.
    const double v = std::min(1.0, 2.0 * from_edge * parameters.cell_m() / width_m);
    const double sign = 2 * i < parameters.cells ? 1.0 : -1.0;
    border.blend.push_back(static_cast<float>(v * v * (3.0 - 2.0 * v)));
    border.blend.push_back(static_cast<float>(sign * 6.0 * v * (1.0 - v) * 2.0 / width_m));
  }
  return border;
}

}  // namespace offing::ocean
