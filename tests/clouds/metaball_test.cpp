// Closed forms of a metaball (C1): each test fails if a coefficient is wrong.
#include "host/clouds/shape/metaball.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace offing::clouds {
namespace {

// The figures have six digits.
constexpr double six_digits = 5e-7;

TEST(MetaballTest, ProfileIsThePolynomial) {
  for (double r = 0.0; r <= 1.0; r += 0.01) {
    EXPECT_NEAR(ball_profile(r),
                1.0 - 4.0 / 9.0 * std::pow(r, 6) + 17.0 / 9.0 * std::pow(r, 4) - 22.0 / 9.0 * r * r, 1e-15);
  }
  EXPECT_EQ(ball_profile(1.0), 0.0);
  EXPECT_EQ(ball_profile(1.5), 0.0);
}

TEST(MetaballTest, SumsAreTheClosedForms) {
  double mass = 0.0, squares = 0.0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double r = (i + 0.5) / steps;
    const double shell = 4.0 * std::numbers::pi * r * r * ball_profile(r) / steps;
    mass += shell;
    squares += shell * r * r;
  }
  EXPECT_NEAR(ball_mass, 0.815595, six_digits);
  EXPECT_NEAR(mass, ball_mass, 1e-8);  // the midpoint rule's error is 1 / steps^2, measured 2e-9
  EXPECT_NEAR(squares / mass, ball_variance, 1e-8);
}

TEST(MetaballTest, ChordsAreTheClosedForms) {
  EXPECT_NEAR(ball_chord(0.0), 0.998942, six_digits);
  EXPECT_NEAR(ball_chord(0.25), 0.828484, six_digits);
  EXPECT_NEAR(ball_chord(0.5), 0.437137, six_digits);
  EXPECT_NEAR(ball_chord(0.75), 0.097531, six_digits);
  EXPECT_EQ(ball_chord(1.0), 0.0);
}

}  // namespace
}  // namespace offing::clouds
