#pragma once

#include <cmath>
#include <numbers>

namespace offing {

/// Below how many deviations this share of a normal distribution is, 0 < share < 1, to 0.003 of a deviation
/// (Winitzki 2008).
inline double deviations_below(double share) {
  constexpr double a = 0.147;
  const double x = 2.0 * share - 1.0, l = std::log(1.0 - x * x);
  const double b = 2.0 / (std::numbers::pi * a) + 0.5 * l;
  return std::copysign(std::sqrt(2.0) * std::sqrt(std::sqrt(b * b - l / a) - b), x);
}

}  // namespace offing
