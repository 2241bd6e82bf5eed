#include "host/clouds/shape/metaball.h"

#include <cmath>
#include <numbers>

namespace offing::clouds {
namespace {

/// Integral of h(r) r^power over 0 ... 1.
constexpr double moment(int power) {
  return 1.0 / (power + 1) - 22.0 / 9.0 / (power + 3) + 17.0 / 9.0 / (power + 5) - 4.0 / 9.0 / (power + 7);
}

}  // namespace

const double ball_mass = 4.0 * std::numbers::pi * moment(2);
const double ball_variance = moment(4) / moment(2);

double ball_profile(double distance) {
  const double s = distance * distance;
  if (!(s < 1.0)) return 0.0;
  // 1 - 22/9 s + 17/9 s^2 - 4/9 s^3, so that rounding leaves nothing below 0.
  return (1.0 - s) * (1.0 - s) * (1.0 - 4.0 / 9.0 * s);
}

double ball_chord(double distance) {
  const double s = distance * distance;
  if (!(s < 1.0)) return 0.0;
  // With u = 1 - s, h at z along the line is (u - z^2)^2 (5/9 + 4/9 (u - z^2)); the integral of (u - z^2)^n
  // over |z| < sqrt(u) is 16/15 u^(5/2) for n = 2 and 32/35 u^(7/2) for n = 3.
  const double u = 1.0 - s;
  return u * u * std::sqrt(u) * (16.0 / 27.0 + 128.0 / 315.0 * u);
}

}  // namespace offing::clouds
