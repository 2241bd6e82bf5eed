#include "host/scene/prepare/spectrum_tail.h"

#include <cmath>

namespace offing::scene {

WaveSpectrum with_tail(WaveSpectrum record, double highest_hz) {
  const double last_hz = record.frequencies_hz.back();
  const double last_energy = record.energy.back();
  // A thousandth further is no tail, and its frequencies would be too close to tell apart.
  if (highest_hz <= 1.001 * last_hz) {
    return record;
  }
  // Straight lines between points 3 % apart lie above f^-5 by at most 5 * 6 / 8 * 0.03^2 = 0.4 %.
  constexpr double largest_step = 0.03;
  const int steps = static_cast<int>(std::ceil(std::log(highest_hz / last_hz) / largest_step));
  const auto directions = static_cast<std::ptrdiff_t>(record.directions_rad.size());
  const std::vector<double> last_row(record.spreading.end() - directions, record.spreading.end());
  for (int i = 1; i <= steps; ++i) {
    const double ratio = std::pow(highest_hz / last_hz, static_cast<double>(i) / steps);
    record.frequencies_hz.push_back(last_hz * ratio);
    record.energy.push_back(last_energy * std::pow(ratio, -5.0));
    record.spreading.insert(record.spreading.end(), last_row.begin(), last_row.end());
  }
  return record;
}

}  // namespace offing::scene
