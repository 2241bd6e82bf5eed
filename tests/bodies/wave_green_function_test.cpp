// The potential of a source under waves, against its definition as an integral.
#include "host/bodies/wave_green_function.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace offing::bodies {
namespace {

/// The integral by Gauss's rule of 3 nodes on pieces.
template <typename Integrand>
double integral(const Integrand& integrand, double from, double to, int pieces) {
  const double step = (to - from) / pieces, off = step * std::sqrt(0.15);
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const double middle = from + (i + 0.5) * step;
    sum += step / 18.0 *
           (5.0 * integrand(middle - off) + 8.0 * integrand(middle) + 5.0 * integrand(middle + off));
  }
  return sum;
}

/// The principal value of 2 integral of g(k) / (k - 1), 0 <= k: around the pole, both sides together.
template <typename Integrand>
double twice_principal_value(const Integrand& g, double x, double y) {
  const double last = 2.0 + 36.0 / y;
  return 2.0 * (integral([&](double s) { return (g(1.0 + s) - g(1.0 - s)) / s; }, 0.0, 1.0, 500) +
                integral([&](double k) { return g(k) / (k - 1.0); }, 2.0, last,
                         static_cast<int>(4.0 * last * (x + 1.0)) + 1000));
}

// F = 2 PV integral of e^(-k Y) J0(k X) / (k - 1) dk (Newman 1985, eq. 1). Fails if a sign, a singular part
// or the seam of table and series is wrong. Bound of the errors 1e-5 (1 + 1 / r); measured 4e-6; limit 1e-5.
TEST(WaveGreenFunctionTest, IsItsIntegral) {
  for (const double x : {0.0, 0.37, 2.2, 3.4, 8.1, 14.2}) {
    for (const double y : {0.1, 1.1, 12.3, 16.5}) {
      const WavePart found = wave_part(x, y);
      const double scale = 1.0 + 1.0 / std::hypot(x, y);
      const auto f = [&](double k) { return std::exp(-k * y) * std::cyl_bessel_j(0.0, k * x); };
      const auto f_x = [&](double k) { return -k * std::exp(-k * y) * std::cyl_bessel_j(1.0, k * x); };
      EXPECT_NEAR(found.f / scale, twice_principal_value(f, x, y) / scale, 1e-5) << x << " " << y;
      EXPECT_NEAR(found.f_x / scale, twice_principal_value(f_x, x, y) / scale, 1e-5) << x << " " << y;
      EXPECT_NEAR(found.decay_j0, f(1.0), 2e-6);
      EXPECT_NEAR(found.decay_j1, -f_x(1.0), 2e-6);
    }
  }
}

// dF/dY = -F - 2 / r and dF/dX hold across the domain. Fails if the table's cells do not fit one another.
// Differences over 1e-3: errors of the table 4e-6 / 1e-3 where they differ, at most.
TEST(WaveGreenFunctionTest, DerivativesFitTheValues) {
  for (double x = 0.2; x < 30.0; x *= 1.21) {
    for (double y = 0.1; y < 30.0; y *= 1.37) {
      const double step = 1e-3, r = std::hypot(x, y);
      const double by_x = (wave_part(x + step, y).f - wave_part(x - step, y).f) / (2.0 * step);
      const double by_y = (wave_part(x, y + step).f - wave_part(x, y - step).f) / (2.0 * step);
      const double scale = 1.0 + 1.0 / (r * r * r);
      EXPECT_NEAR(by_x, wave_part(x, y).f_x, 4e-3 * scale) << x << " " << y;
      EXPECT_NEAR(by_y, -wave_part(x, y).f - 2.0 / r, 4e-3 * scale) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace offing::bodies
