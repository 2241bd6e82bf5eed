#include "host/io/spectra/maximum_entropy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace offing::spectra {
namespace {

using Complex = std::complex<double>;

constexpr double spacing_rad = 2.0 * std::numbers::pi / direction_count;

// D is sampled 4 to 256 times a table cell, so that the nearest peak to the unit circle is resolved: sampling
// a pole of radius r at M points errs by r^M relative: 1e-4 asked, 2e-7 for r = 0.9995 and M = 120 * 256.
constexpr int finest_samples_a_cell = 256;
constexpr double largest_pole_radius = 0.9995;
constexpr double sampling_error = 1e-4;

const std::vector<Complex>& unit_circle() {
  static const std::vector<Complex> points = [] {
    const int count = direction_count * finest_samples_a_cell;
    std::vector<Complex> circle(count);
    for (int i = 0; i < count; ++i) circle[i] = std::polar(1.0, -2.0 * std::numbers::pi * i / count);
    return circle;
  }();
  return points;
}

// Coefficients of the second-order autoregressive process with these covariances.
struct Autoregression {
  Complex p1;
  Complex p2;

  explicit Autoregression(const DirectionalMoments& m)
      : p1((m.first - m.second * std::conj(m.first)) / (1.0 - std::norm(m.first))),
        p2(m.second - m.first * p1) {}

  // Radius of the pole that is nearest to the unit circle: roots of z^2 - p1 z - p2.
  double pole_radius() const {
    const Complex root = std::sqrt(p1 * p1 + 4.0 * p2);
    return 0.5 * std::max(std::abs(p1 + root), std::abs(p1 - root));
  }
};

Complex cut_to(Complex value, double limit) {
  const double size = std::abs(value);
  return size > limit ? value * (limit / size) : value;
}

void normalise(SpreadingRow row) {
  double sum = 0.0;
  for (const double value : row) sum += value;
  for (double& value : row) value /= sum * spacing_rad;
}

double square_of_sinc(double x) {
  const double sinc = std::sin(x) / x;
  return sinc * sinc;
}

}  // namespace

DirectionalMoments admissible_moments(DirectionalMoments moments) {
  moments.first = cut_to(moments.first, largest_first_moment);
  const double room = 1.0 - std::norm(moments.first);
  const Complex k2 = cut_to((moments.second - moments.first * moments.first) / room, 0.999);
  const auto with_share = [&](double share) {
    return DirectionalMoments{moments.first, moments.first * moments.first + share * k2 * room};
  };
  const auto is_resolved = [](const DirectionalMoments& m) {
    return Autoregression(m).pole_radius() <= largest_pole_radius;
  };
  if (is_resolved(with_share(1.0))) return with_share(1.0);
  // At k2 = 0 the poles are c1 and 0, well inside; twelve halvings find the largest share to 1/4096.
  double inside = 0.0;
  double outside = 1.0;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (inside + outside);
    (is_resolved(with_share(middle)) ? inside : outside) = middle;
  }
  return with_share(inside);
}

void maximum_entropy_spreading(DirectionalMoments moments, SpreadingRow row) {
  // Averaging over neighbouring cells with triangular weights multiplies moment n by sinc^2(n spacing / 2).
  moments.first /= square_of_sinc(0.5 * spacing_rad);
  moments.second /= square_of_sinc(spacing_rad);
  const DirectionalMoments m = admissible_moments(moments);
  const Autoregression process(m);

  const double radius = process.pole_radius();
  int samples_a_cell = 4;
  while (samples_a_cell < finest_samples_a_cell &&
         std::pow(radius, direction_count * samples_a_cell) > sampling_error) {
    samples_a_cell *= 2;
  }
  const std::vector<Complex>& circle = unit_circle();
  const int stride = finest_samples_a_cell / samples_a_cell;
  std::fill(row.begin(), row.end(), 0.0);
  for (int cell = 0; cell < direction_count; ++cell) {
    const int next = cell + 1 == direction_count ? 0 : cell + 1;
    for (int i = 0; i < samples_a_cell; ++i) {
      const Complex w = circle[static_cast<std::size_t>(cell * samples_a_cell + i) * stride];
      const double density = 1.0 / std::norm(1.0 - w * (process.p1 + process.p2 * w));
      const double toward_next = static_cast<double>(i) / samples_a_cell;
      row[cell] += (1.0 - toward_next) * density;
      row[next] += toward_next * density;
    }
  }
  normalise(row);
}

void cosine_power_spreading(std::complex<double> first_moment, SpreadingRow row) {
  const Complex c1 = cut_to(first_moment, largest_first_moment);
  const double r1 = std::abs(c1);
  const double exponent = 2.0 * r1 / (1.0 - r1);
  const double mean_rad = std::arg(c1);
  for (int j = 0; j < direction_count; ++j) {
    const double half_angle = 0.5 * (j * spacing_rad - mean_rad);
    row[j] = std::pow(std::abs(std::cos(half_angle)), exponent);
  }
  normalise(row);
}

}  // namespace offing::spectra
