#include "host/ocean/spectrum/quadrature.h"

#include <algorithm>
#include <cmath>

namespace offing::ocean {

std::vector<double> log_wavenumber_panels(const SeaSpectrum& spectrum, double log_k_low, double log_k_high,
                                          int count) {
  std::vector<double> edges;
  edges.reserve(count + 1 + spectrum.kinks_radps.size());
  for (int i = 0; i <= count; ++i) {
    edges.push_back(std::lerp(log_k_low, log_k_high, static_cast<double>(i) / count));
  }
  for (const double omega_radps : spectrum.kinks_radps) {
    const double log_k = std::log(spectrum.dispersion.wavenumber_radpm(omega_radps));
    if (log_k > log_k_low && log_k < log_k_high) {
      edges.push_back(log_k);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

double energy_per_log_k(const SeaSpectrum& spectrum, double k_radpm, double omega_radps) {
  return spectrum.energy(omega_radps) * spectrum.dispersion.group_speed_mps(k_radpm) * k_radpm;
}

}  // namespace offing::ocean
