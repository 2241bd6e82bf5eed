// The density of clouds on the device against closed forms and a double-precision reference (C1 ... C3).
#include "host/clouds/shape/cloud_density.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/clouds/shape/metaball.h"
#include "tests/clouds/reference_density.h"
#include "tests/clouds/volume_cells.h"
#include "tests/ocl/expect_error.h"

namespace offing::clouds {
namespace {

CloudParameters one_ball(double radius_m, const glm::dvec3& centre_m) {
  CloudParameters parameters;
  parameters.balls = {{centre_m, radius_m, 1.0}};
  parameters.turbulence.blend = 0.0;
  parameters.look.extinction_per_m = 1.0;
  return parameters;
}

class CloudDensityTest : public testing::Test {
 protected:
  const ocl::Device device_ = ocl::Device::open();
};

// Fails if cells are missing, counted twice or shifted. h is level at its rim, so that the sum over cells of
// a 16th of the radius is the integral to 1e-5; measured 1.5e-6. Gate as accepted, 1e-4.
TEST_F(CloudDensityTest, OneBallSumsToItsMass) {
  for (const double radius_m : {16.0, 40.0, 77.7}) {
    const CloudVolume volume = field_volume(device_, one_ball(radius_m, {3.3, -70.1, 12.9}), 1.0, 0.0);
    EXPECT_NEAR(optical_mass(volume) / std::pow(radius_m, 3), 0.815595, 1e-4) << radius_m;
  }
}

// Fails if the field is stretched along an axis. Cells of a 40th of the radius along a line: measured 1e-6.
TEST_F(CloudDensityTest, ChordsAreTheClosedForms) {
  const CloudVolume volume = field_volume(device_, one_ball(40.0, glm::dvec3(0.5)), 1.0, 0.0);
  for (int axis = 0; axis < 3; ++axis) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      double sum = 0.0;
      for (int i = -45; i <= 45; ++i) {
        glm::dvec3 place_m(0.5);
        place_m[axis] += i;
        place_m[(axis + 1) % 3] += 10.0 * quarter;
        sum += density_at(volume, place_m);
      }
      EXPECT_NEAR(sum / 40.0, ball_chord(0.25 * quarter), 1e-4) << axis << ' ' << quarter;
    }
  }
}

CloudParameters frayed_cloud(const glm::dvec3& middle_m) {
  CloudParameters parameters;
  parameters.seed = 0x123456789abcdef0u;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 place(uniform(random), uniform(random), uniform(random));
    parameters.balls.push_back({middle_m + 150.0 * place, 60.0 + 30.0 * uniform(random), 1.0});
  }
  parameters.turbulence = {.wavelength_m = 130.0,
                           .octaves = 5,
                           .lacunarity = 2.1,
                           .gain = 0.6,
                           .strength = 1.3,
                           .blend = 0.6,
                           .wisp = 1.4,
                           .edge = 0.4,
                           .change_per_s = 0.05};
  return parameters;
}

// Fails if any part of the kernel is wrong: balls, bins, fixed-point places, lattice, octaves, the sum.
// Bound: places within a brick lose 2^-24 of 8 cells, on which h changes by 1.3 over the radius: 1e-6 each;
// noise adds 2^-24 of 3 amplitudes times its slope: 2e-6; balls far from the origin are rounded once, where
// they are relative to the grid. Measured 1e-6, the largest density 1.5, at both places. Gate 1e-5 of it.
TEST_F(CloudDensityTest, AgreesWithTheReference) {
  for (const glm::dvec3& middle_m : {glm::dvec3(0.0), glm::dvec3(-3e5, 4000.0, 2.5e5)}) {
    const CloudParameters parameters = frayed_cloud(middle_m);
    constexpr double cell_m = 5.0, time_s = 1234.5;
    const CloudVolume volume = field_volume(device_, parameters, cell_m, time_s);
    double worst = 0.0, largest = 0.0;
    std::size_t number = 0;
    for_cells(volume, [&](const glm::dvec3& place_m, float density) {
      if (number++ % 7 != 0) return;
      const double expected = reference_density(parameters, place_m, time_s, 2.0 * cell_m);
      worst = std::max(worst, std::abs(static_cast<double>(density) - expected));
      largest = std::max(largest, expected);
    });
    EXPECT_GT(number, 100'000u);
    EXPECT_LT(worst, 1e-5 * largest) << "largest " << largest;
  }
}

// Fails if bricks without density are kept or such with density left out.
TEST_F(CloudDensityTest, KeepsBricksWithDensityAlone) {
  CloudParameters parameters = one_ball(30.0, {0.0, 0.0, 0.0});
  parameters.balls.push_back({{900.0, 0.0, 0.0}, 20.0, 1.0});
  const CloudVolume volume = field_volume(device_, parameters, 2.0, 0.0);
  const std::size_t kept = volume.density.size() / CloudVolume::cells_of_brick;
  EXPECT_LE(kept, 100u);  // 4^3 around the larger ball, at most 4^3 around the other
  EXPECT_GE(volume.brick_of.size(), 900u);
  for (std::size_t i = 0; i < kept; ++i) {
    const auto first = volume.density.begin() + static_cast<std::ptrdiff_t>(i * CloudVolume::cells_of_brick);
    EXPECT_GT(*std::max_element(first, first + CloudVolume::cells_of_brick), 0.0f);
  }
  EXPECT_NEAR(optical_mass(volume), ball_mass * (27'000.0 + 8'000.0), 4.0);
}

// Fails if a shape is read at other places than its cells', or cut at the borders of bricks.
TEST_F(CloudDensityTest, ShapeTakesThePlaceOfBalls) {
  CloudParameters parameters = one_ball(40.0, {10.0, 20.0, 30.0});
  const CloudVolume expected = field_volume(device_, parameters, 2.0, 0.0);
  parameters.shape = std::make_shared<const CloudVolume>(expected);
  parameters.balls.clear();
  const CloudVolume same = field_volume(device_, parameters, 2.0, 0.0);
  for_cells(expected, [&](const glm::dvec3& place_m, float density) {
    ASSERT_NEAR(density_at(same, place_m), static_cast<double>(density), 1e-5);
  });
  // Interpolated to finer cells it keeps its sum but for what the weights of cells do: measured 1e-6, bound
  // 1e-3 of a rim of one cell in 20.
  const CloudVolume fine = field_volume(device_, parameters, 1.3, 0.0);
  EXPECT_NEAR(optical_mass(fine) / optical_mass(expected), 1.0, 1e-3);
}

// Fails if a particle's cells are not normalised, above all where it is smaller than a cell. Floats round
// each cell to 6e-8: gate 1e-6.
TEST_F(CloudDensityTest, RasterisedParticlesKeepTheirMass) {
  for (const float radius_m : {0.01f, 0.6f, 1.0f, 1.7f, 5.0f, 33.0f}) {
    for (const float shift_m : {0.0f, 0.31f, 0.5f, 1234.77f}) {
      CloudParticle particle{};
      particle.x = shift_m;
      particle.y = 0.3f - shift_m;
      particle.z = 2.0f * shift_m;
      particle.radius = radius_m;
      particle.optical_mass = 12.5f;
      const CloudVolume volume = rasterised(device_, std::span(&particle, 1), 1.0, 0.02);
      EXPECT_NEAR(optical_mass(volume) / 12.5, 1.0, 1e-6) << radius_m << ' ' << shift_m;
    }
  }
  EXPECT_EQ(optical_mass(rasterised(device_, {}, 1.0)), 0.0);
}

TEST_F(CloudDensityTest, RefusesWhatIsOutOfRange) {
  CloudParameters parameters = one_ball(-1.0, glm::dvec3(0.0));
  offing::test::expect_error(ErrorKind::bad_input, "cloud.ball[0].radius_m",
                     [&] { field_volume(device_, parameters, 1.0, 0.0); });
  parameters = one_ball(1e5, glm::dvec3(0.0));
  offing::test::expect_error(ErrorKind::bad_input, "cell_m 0.1",
                     [&] { field_volume(device_, parameters, 0.1, 0.0); });
  CloudParticle particle{};
  particle.radius = std::numeric_limits<float>::quiet_NaN();
  offing::test::expect_error(ErrorKind::bad_input, "cloud particle 0: radius",
                     [&] { rasterised(device_, std::span(&particle, 1), 1.0); });
  CloudVolume shape = field_volume(device_, one_ball(10.0, glm::dvec3(0.0)), 1.0, 0.0);
  shape.density[5] = std::numeric_limits<float>::quiet_NaN();
  parameters.shape = std::make_shared<const CloudVolume>(shape);
  parameters.balls.clear();
  offing::test::expect_error(ErrorKind::bad_input, "nan", [&] { field_volume(device_, parameters, 1.0, 0.0); });
}

}  // namespace
}  // namespace offing::clouds
