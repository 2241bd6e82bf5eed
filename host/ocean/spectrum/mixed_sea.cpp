#include "host/ocean/spectrum/mixed_sea.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "host/base/error.h"

namespace offing::ocean {

SeaSpectrum sum_of(std::vector<SeaSpectrum> seas) {
  if (seas.empty()) throw Error(ErrorKind::bad_usage, "seas: expected at least one, found none", "add one");
  if (seas.size() == 1) return std::move(seas.front());
  const auto parts = std::make_shared<const std::vector<SeaSpectrum>>(std::move(seas));
  SeaSpectrum sum;
  sum.dispersion = parts->front().dispersion;
  sum.omega_min_radps = parts->front().omega_min_radps;
  for (const SeaSpectrum& part : *parts) {
    sum.omega_min_radps = std::min(sum.omega_min_radps, part.omega_min_radps);
    sum.omega_max_radps = std::max(sum.omega_max_radps, part.omega_max_radps);
    sum.kinks_radps.insert(sum.kinks_radps.end(), part.kinks_radps.begin(), part.kinks_radps.end());
    // Where it begins and ends, and where it is largest.
    sum.kinks_radps.insert(sum.kinks_radps.end(),
                           {part.omega_min_radps, part.omega_max_radps, part.omega_peak_radps});
  }
  std::sort(sum.kinks_radps.begin(), sum.kinks_radps.end());
  const auto repeated = std::unique(sum.kinks_radps.begin(), sum.kinks_radps.end());
  sum.kinks_radps.erase(repeated, sum.kinks_radps.end());

  sum.energy = [parts](double omega_radps) {
    double energy = 0.0;
    for (const SeaSpectrum& part : *parts) energy += part.energy(omega_radps);
    return energy;
  };
  sum.spreading_at = [parts](double omega_radps) -> DirectionalDensity {
    std::vector<std::pair<double, DirectionalDensity>> shares;  // of the energy there
    double total = 0.0;
    for (const SeaSpectrum& part : *parts) {
      const double energy = part.energy(omega_radps);
      if (energy <= 0.0) continue;
      shares.emplace_back(energy, part.spreading_at(omega_radps));
      total += energy;
    }
    if (shares.empty()) return parts->front().spreading_at(omega_radps);
    for (auto& [share, density] : shares) share /= total;
    return [shares = std::move(shares)](double direction_rad) {
      double sum_of_shares = 0.0;
      for (const auto& [share, density] : shares) sum_of_shares += share * density(direction_rad);
      return sum_of_shares;
    };
  };
  sum.omega_peak_radps = find_peak_radps(sum);
  return sum;
}

}  // namespace offing::ocean
