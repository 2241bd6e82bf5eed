#include "host/io/spectra/maximum_entropy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace offing::spectra {
namespace {

using Complex = std::complex<double>;

constexpr double spacing_rad = 2.0 * std::numbers::pi / direction_count;

using Row = std::array<double, direction_count>;

Complex moment(const Row& row, int n) {
  Complex sum;
  for (int j = 0; j < direction_count; ++j) sum += row[j] * std::polar(spacing_rad, n * j * spacing_rad);
  return sum;
}

double integral(const Row& row) {
  return moment(row, 0).real();
}

double smallest(const Row& row) {
  return *std::min_element(row.begin(), row.end());
}

// Fails if the table does not carry the moments: Burg's function for these moments has them exactly, so what
// is left is the sampling of the table. Bound 1e-3, measured 6.4e-4 (the narrowest peaks);
// the averaging over cells alone, not undone, would take 9e-4 off the second moment (1 - sinc^2 of 3
// degrees).
TEST(MaximumEntropy, ReproducesAdmissibleMoments) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) {
    // All moments with |k1|, |k2| <= 0.97 are admissible: c1 = k1, c2 = c1^2 + k2 (1 - |c1|^2).
    const Complex k1 = std::polar(0.97 * std::sqrt(unit(random)), 2.0 * std::numbers::pi * unit(random));
    const Complex k2 = std::polar(0.97 * std::sqrt(unit(random)), 2.0 * std::numbers::pi * unit(random));
    const DirectionalMoments asked{k1, k1 * k1 + k2 * (1.0 - std::norm(k1))};
    Row row;
    maximum_entropy_spreading(asked, row);
    EXPECT_GE(smallest(row), 0.0);
    EXPECT_NEAR(integral(row), 1.0, 1e-12);
    worst =
        std::max({worst, std::abs(moment(row, 1) - asked.first), std::abs(moment(row, 2) - asked.second)});
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 1e-3);
}

// Fails if the formula is another than Lygre & Krogstad's: written out here a second time, from the linear
// system [1 c1*; c1 1] [p1; p2] = [c1; c2] of the autoregression that has these covariances.
TEST(MaximumEntropy, IsTheAutoregressiveSpectrum) {
  const Complex c1 = std::polar(0.55, 0.7);
  const Complex c2 = std::polar(0.25, 1.1);
  const Complex determinant = 1.0 - std::conj(c1) * c1;
  const Complex p1 = (c1 - std::conj(c1) * c2) / determinant;
  const Complex p2 = (c2 - c1 * c1) / determinant;
  const double variance = (1.0 - p1 * std::conj(c1) - p2 * std::conj(c2)).real();
  Row row;
  maximum_entropy_spreading({c1, c2}, row);
  for (int j = 0; j < direction_count; ++j) {
    const Complex w = std::polar(1.0, -j * spacing_rad);
    const double expected = variance / std::norm(1.0 - p1 * w - p2 * w * w) / (2.0 * std::numbers::pi);
    // The table's values are means over cells of 3 degrees: D'' spacing^2 / 12 away for this broad function,
    // of which the compensation of the moments takes back most.
    EXPECT_NEAR(row[j], expected, 2e-3 * expected + 1e-4) << j;
  }
}

// Fails if a peak falls between samples and its energy is lost, or if it moves: swell of 2 to 5 degrees
// spread, at every position relative to the table.
TEST(MaximumEntropy, KeepsNarrowPeaksWhole) {
  for (const double spread_deg : {5.0, 3.0, 2.1}) {
    for (int step = 0; step < 24; ++step) {
      const double mean_rad = 1.0 + step * spacing_rad / 24.0;
      const double r1 = 1.0 - 0.5 * std::pow(spread_deg * std::numbers::pi / 180.0, 2);
      const DirectionalMoments asked{std::polar(r1, mean_rad), std::polar(std::pow(r1, 4), 2.0 * mean_rad)};
      Row row;
      maximum_entropy_spreading(asked, row);
      EXPECT_NEAR(integral(row), 1.0, 1e-12);
      EXPECT_GE(smallest(row), 0.0);
      EXPECT_NEAR(std::arg(moment(row, 1) / asked.first), 0.0, 1e-3) << spread_deg;
      EXPECT_NEAR(std::abs(moment(row, 1)), r1, 1e-3) << spread_deg;
    }
  }
}

// Fails if noise that no spreading function can have (|c1| >= 1, |c2 - c1^2| > 1 - |c1|^2) gives negative or
// infinite densities, or turns the mean direction. First moments up to 0.99 must come through unchanged.
TEST(MaximumEntropy, ShrinksInadmissibleMoments) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> box(-1.5, 1.5);
  for (int i = 0; i < 4000; ++i) {
    const DirectionalMoments asked{{box(random), box(random)}, {box(random), box(random)}};
    Row row;
    maximum_entropy_spreading(asked, row);
    EXPECT_GE(smallest(row), 0.0);
    EXPECT_NEAR(integral(row), 1.0, 1e-12);
    EXPECT_NEAR(std::arg(moment(row, 1) / asked.first), 0.0, 0.01 / std::abs(asked.first));
    if (std::abs(asked.first) < 0.99) {
      EXPECT_NEAR(std::abs(moment(row, 1) - asked.first), 0.0, 1e-3);
    }
  }
}

// Fails if admissible_moments() touches what needs no mending.
TEST(MaximumEntropy, LeavesAdmissibleMomentsAlone) {
  const DirectionalMoments asked{std::polar(0.8, 2.0), std::polar(0.42, 3.9)};
  const DirectionalMoments kept = admissible_moments(asked);
  EXPECT_NEAR(std::abs(kept.first - asked.first), 0.0, 1e-15);
  EXPECT_NEAR(std::abs(kept.second - asked.second), 0.0, 1e-15);
}

TEST(MaximumEntropy, IsUniformWithoutMoments) {
  Row row;
  maximum_entropy_spreading({0.0, 0.0}, row);
  for (const double density : row) EXPECT_NEAR(density, 0.5 / std::numbers::pi, 1e-15);
}

// Fails if s does not follow from r1: cos^2s has r1 = s / (s + 1) and r2 = s (s - 1) / ((s + 1) (s + 2)).
TEST(CosinePower, HasTheMomentsOfItsLaw) {
  for (const double s : {0.0, 0.5, 1.0, 5.0, 25.0, 400.0}) {
    const double mean_rad = 2.345;
    Row row;
    cosine_power_spreading(std::polar(s / (s + 1.0), mean_rad), row);
    EXPECT_NEAR(integral(row), 1.0, 1e-12);
    // Exact but for the kink of |cos|^1 at s = 0.5 (spacing^2 / 12 = 6e-4) and aliasing at s = 400 (1e-6).
    const double gate = s == 0.5 ? 1e-3 : 1e-5;
    const Complex second = std::polar(s * (s - 1.0) / ((s + 1.0) * (s + 2.0)), 2.0 * mean_rad);
    EXPECT_NEAR(std::abs(moment(row, 1) - std::polar(s / (s + 1.0), mean_rad)), 0.0, gate) << s;
    EXPECT_NEAR(std::abs(moment(row, 2) - second), 0.0, gate) << s;
  }
}

TEST(CosinePower, StaysWholeAtTheNarrowest) {
  for (const double r1 : {0.9999, 1.0, 3.0}) {
    Row row;
    cosine_power_spreading(std::polar(r1, 0.5 * spacing_rad), row);
    EXPECT_NEAR(integral(row), 1.0, 1e-12);
    EXPECT_NEAR(std::arg(moment(row, 1)), 0.5 * spacing_rad, 1e-3);
  }
}

}  // namespace
}  // namespace offing::spectra
