#include "host/ocean/surface/water_optics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace offing::ocean {
namespace {

/// Of pure sea water, 1/m.
constexpr std::array<double, 3> molecular_backscatter_perm{0.0006, 0.00097, 0.0020};

struct TableRow {
  std::array<double, 3> attenuation_perm;
  double particle_backscatter_perm;
};

/// In the order of WaterType.
constexpr std::array<TableRow, 10> rows{{
    {{0.277, 0.063, 0.0186}, 0.0005},
    {{0.282, 0.067, 0.0254}, 0.0012},
    {{0.287, 0.072, 0.0342}, 0.003},
    {{0.305, 0.089, 0.0644}, 0.006},
    {{0.343, 0.120, 0.1236}, 0.012},
    {{0.342, 0.120, 0.202}, 0.012},
    {{0.372, 0.190, 0.330}, 0.025},
    {{0.448, 0.300, 0.482}, 0.045},
    {{0.516, 0.460, 0.782}, 0.08},
    {{0.630, 0.630, 1.378}, 0.13},
}};

}  // namespace

WaterOptics water_optics(WaterType type) {
  const TableRow& row = rows[static_cast<std::size_t>(type)];
  WaterOptics optics{.attenuation_perm = row.attenuation_perm, .reflectance = {}};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double backscatter_perm = molecular_backscatter_perm[channel] + row.particle_backscatter_perm;
    optics.reflectance[channel] = 0.33 * backscatter_perm / row.attenuation_perm[channel];
  }
  return optics;
}

double visible_depth_m(const WaterOptics& optics) {
  const double least_perm = *std::ranges::min_element(optics.attenuation_perm);
  return std::log(2.0 * 255.0) / (2.0 * least_perm);
}

}  // namespace offing::ocean
