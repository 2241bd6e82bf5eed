#include "host/bodies/wave_green_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace offing::bodies {
namespace {

using std::numbers::pi;
constexpr double euler = std::numbers::egamma;

struct Bessel {
  double j0, j1, y0;
  double y1_rest;  ///< Y1(X) + 2 / (pi X)
};

double polynomial(double x, std::array<double, 7> c) {
  double sum = 0.0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// Abramowitz & Stegun 1964, 9.4.1 to 9.4.6: errors below 1.2e-7, divided by X for J1 and Y1 below X = 3.
Bessel bessel(double x) {
  if (x <= 3.0) {
    const double s = x * x / 9.0;
    const double log_term = 2.0 / pi * std::log(0.5 * std::max(x, 1e-12));
    Bessel b{};
    b.j0 = polynomial(s, {1.0, -2.2499997, 1.2656208, -0.3163866, 0.0444479, -0.0039444, 0.0002100});
    b.j1 =
        x * polynomial(s, {0.5, -0.56249985, 0.21093573, -0.03954289, 0.00443319, -0.00031761, 0.00001109});
    b.y0 = log_term * b.j0 + polynomial(s, {0.36746691, 0.60559366, -0.74350384, 0.25300117, -0.04261214,
                                            0.00427916, -0.00024846});
    b.y1_rest =
        log_term * b.j1 +
        x / 9.0 * polynomial(s, {0.2212091, 2.1682709, -1.3164827, 0.3123951, -0.0400976, 0.0027873, 0.0});
    return b;
  }
  const double s = 3.0 / x, root = 1.0 / std::sqrt(x);
  const double f0 =
      polynomial(s, {0.79788456, -0.00000077, -0.00552740, -0.00009512, 0.00137237, -0.00072805, 0.00014476});
  const double t0 = x + polynomial(s, {-0.78539816, -0.04166397, -0.00003954, 0.00262573, -0.00054125,
                                       -0.00029333, 0.00013558});
  const double f1 =
      polynomial(s, {0.79788456, 0.00000156, 0.01659667, 0.00017105, -0.00249511, 0.00113653, -0.00020033});
  const double t1 = x + polynomial(s, {-2.35619449, 0.12499612, 0.00005650, -0.00637879, 0.00074348,
                                       0.00079824, -0.00029166});
  return {f0 * root * std::cos(t0), f1 * root * std::cos(t1), f0 * root * std::sin(t0),
          f1 * root * std::sin(t1) + 2.0 / (pi * x)};
}

/// Struve's H0 and H1 by their power series (Abramowitz & Stegun 1964, 12.1.4, 12.1.5): 1e-8 up to X = 21.
struct Struve {
  double h0, h1;
};
Struve struve(double x) {
  double term0 = 2.0 / pi * x, term1 = 2.0 / (3.0 * pi) * x * x;
  Struve sum{term0, term1};
  for (int k = 1; k < 60; ++k) {
    const double odd = 2.0 * k + 1.0;
    term0 *= -x * x / (odd * odd);
    term1 *= -x * x / (odd * (odd + 2.0));
    sum.h0 += term0;
    sum.h1 += term1;
  }
  return sum;
}

/// What stays smooth of F and dF/dX when their singular parts are out.
struct Smooth {
  double f, f_x;
};
Smooth singular(double x, double y, double r, double decay_j0, double decay_j1) {
  const double log = std::log(0.5 * (r + y)) + euler;
  return {-2.0 * decay_j0 * log, 2.0 * decay_j1 * log - 2.0 * decay_j0 * x / (r * (r + y))};
}

/// By quadrature with t = X sinh s, Gauss's rule of 10 nodes on pieces.
Smooth smooth_part(double x, double y) {
  constexpr std::array<double, 5> nodes{0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                                        0.8650633666889845, 0.9739065285171717};
  constexpr std::array<double, 5> weights{0.2955242247147529, 0.2692667193099963, 0.2190863625159820,
                                          0.1494513491505806, 0.0666713443086881};
  x = std::max(x, 1e-9);  // this form has no limit on the axis, where dF/dX = 0
  const double r = std::hypot(x, y), decay = std::exp(-y), top = std::asinh(y / x);
  const int pieces = 1 + static_cast<int>(top);
  double sum = 0.0, sum_x = 0.0;  // of (e^t - 1) / sqrt(X^2 + t^2), of X (e^t - 1) / sqrt(X^2 + t^2)^3
  for (int piece = 0; piece < pieces; ++piece) {
    const double half = 0.5 * top / pieces, middle = (2 * piece + 1) * half;
    for (std::size_t i = 0; i < 2 * nodes.size(); ++i) {
      const double s = middle + (i % 2 == 0 ? half : -half) * nodes[i / 2];
      const double grown = std::expm1(x * std::sinh(s)) * half * weights[i / 2];
      sum += grown;
      sum_x += grown / (x * std::cosh(s) * std::cosh(s));
    }
  }
  const Bessel b = bessel(x);
  const Struve h = struve(x);
  const double f = decay * (-2.0 * sum - 2.0 * top - pi * (h.h0 + b.y0));
  // 2 Y / (X r) of the integral of 1 and pi Y1 = -2 / X + ... are singular alone.
  const double f_x = decay * (2.0 * sum_x - 2.0 * x / (r * (r + y)) - 2.0 + pi * (h.h1 + b.y1_rest));
  const Smooth out = singular(x, y, r, decay * b.j0, decay * b.j1);
  return {f - out.f, f_x - out.f_x};
}

/// The smooth parts over r = sqrt(X^2 + Y^2) and the tangent of half the angle from the vertical, X / (r +
/// Y).
class Table {
 public:
  static constexpr double last_r = 14.0;

  Table() : entries_(rows * columns) {
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const double r = std::max(row * step_r, 1e-4), t = column * step_t;
        const double y = r * (1.0 - t * t) / (1.0 + t * t), x = r * 2.0 * t / (1.0 + t * t);
        entries_[static_cast<std::size_t>(row * columns + column)] = smooth_part(x, std::max(y, 0.0));
      }
    }
  }

  /// By polynomials of degree 5 in both coordinates.
  Smooth at(double r, double t) const {
    const double row = r / step_r, column = t / step_t;
    const int first_row = std::clamp(static_cast<int>(row) - 2, 0, rows - 6);
    const int first_column = std::clamp(static_cast<int>(column) - 2, 0, columns - 6);
    const std::array<double, 6> by_row = weights(row - first_row), by_column = weights(column - first_column);
    Smooth sum{0.0, 0.0};
    for (int i = 0; i < 6; ++i) {
      const Smooth* entry = &entries_[static_cast<std::size_t>((first_row + i) * columns + first_column)];
      double f = 0.0, f_x = 0.0;
      for (std::size_t j = 0; j < 6; ++j) {
        f += by_column[j] * entry[j].f;
        f_x += by_column[j] * entry[j].f_x;
      }
      sum.f += by_row[static_cast<std::size_t>(i)] * f;
      sum.f_x += by_row[static_cast<std::size_t>(i)] * f_x;
    }
    return sum;
  }

 private:
  static constexpr double step_r = 0.15, step_t = 1.0 / 64.0;
  static constexpr int rows = 97, columns = 65;

  /// Lagrange's weights of the nodes 0 ... 5.
  static std::array<double, 6> weights(double u) {
    const double a = u, b = u - 1.0, c = u - 2.0, d = u - 3.0, e = u - 4.0, f = u - 5.0;
    const double abc = a * b * c, def = d * e * f;
    return {b * c * def / -120.0, a * c * def / 24.0,  a * b * def / -12.0,
            abc * e * f / 12.0,   abc * d * f / -24.0, abc * d * e / 120.0};
  }

  std::vector<Smooth> entries_;
};

/// F = wave + local part far away, the local part -2 sum of n! P_n(Y / r) / r^(n + 1).
Smooth local_part(double x, double y, double r) {
  const double over_r2 = 1.0 / (r * r);
  double before = 0.0, before_x = 0.0, term = 1.0 / r, term_x = -x * over_r2 / r;
  Smooth sum{term, term_x};
  for (int n = 0; n < 12; ++n) {
    const double next = ((2 * n + 1) * y * term - n * n * before) * over_r2;
    const double next_x = ((2 * n + 1) * y * term_x - n * n * before_x - 2.0 * x * next) * over_r2;
    before = term;
    before_x = term_x;
    term = next;
    term_x = next_x;
    sum.f += term;
    sum.f_x += term_x;
  }
  return {-2.0 * sum.f, -2.0 * sum.f_x};
}

}  // namespace

WavePart wave_part(double x, double y) {
  static const Table table;
  const double r = std::sqrt(x * x + y * y);
  // e^-14 is below the accuracy.
  if (r > Table::last_r && y > 14.0) {
    const Smooth local = local_part(x, y, r);
    return {local.f, local.f_x, 0.0, 0.0};
  }
  const Bessel b = bessel(x);
  const double decay = std::exp(-y), decay_j0 = decay * b.j0, decay_j1 = decay * b.j1;
  if (r > Table::last_r) {
    const Smooth local = local_part(x, y, r);
    const double y1 = b.y1_rest - 2.0 / (pi * x);
    return {local.f - 2.0 * pi * decay * b.y0, local.f_x + 2.0 * pi * decay * y1, decay_j0, decay_j1};
  }
  const Smooth smooth = table.at(r, x / (r + y)), out = singular(x, y, r, decay_j0, decay_j1);
  return {smooth.f + out.f, smooth.f_x + out.f_x, decay_j0, decay_j1};
}

}  // namespace offing::bodies
