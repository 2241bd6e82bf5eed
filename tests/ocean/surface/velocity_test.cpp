// Particle velocity against linear theory. tests/ocean/surface/ocean_reference_test.cpp compares whole
// fields; here are the properties that theory asks for. The waves' period is 5 ... 8 s, their height 1 m.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/ocean/surface/field_statistics.h"
#include "tests/ocean/surface/single_wave.h"

namespace offing::ocean {
namespace {

constexpr int size = 256;

class VelocityTest : public testing::Test {
 protected:
  SingleWave wave(double depth_m) const {
    return {.patch_length_m = 120.0,
            .column = 2,
            .row = -1,
            .amplitude_m = 0.5,
            .dispersion = {.depth_m = depth_m}};
  }
  Ocean sea_of(const SingleWave& wave) {
    const OceanParameters parameters{.size = size, .cascades = {{wave.patch_length_m, 0.0, 1e9}}};
    return Ocean(device_, single_wave_spectrum(wave, parameters), parameters);
  }
  // Amplitudes of a sinusoid: sqrt(2) of its root mean square.
  static double vertical(const VelocityFields& velocity) { return std::sqrt(2.0 * mean_square(velocity.y)); }
  static double horizontal(const VelocityFields& velocity) {
    return std::sqrt(2.0 * (mean_square(velocity.x) + mean_square(velocity.z)));
  }

  ocl::Device device_ = ocl::Device::open();
};

// Fails if the vertical velocity at the surface is not the rate at which it rises. Central differences over
// 2 x 0.02 s: truncation (w dt)^2 / 6 = 1e-4 for w = 1.2 rad/s, rounding 2e-6 / (w dt) = 1e-4. Gate 5e-4.
TEST_F(VelocityTest, SurfaceRisesAtTheVerticalVelocity) {
  Ocean sea = sea_of(wave(9.0));
  const double dt_s = 0.02, time_s = 41.0;
  sea.at(time_s - dt_s);
  const std::vector<float> before = sea.read_surface(0).displacement_y;
  sea.at(time_s + dt_s);
  std::vector<float> rise = sea.read_surface(0).displacement_y;
  for (std::size_t i = 0; i < rise.size(); ++i)
    rise[i] = (rise[i] - before[i]) / static_cast<float>(2.0 * dt_s);
  sea.at(time_s);
  EXPECT_LT(relative_error(sea.read_velocity(0).y, rise), 5e-4);
}

// Fails if orbits in deep water are not circles that shrink as e^{-kd}. Gate 1e-5: single precision.
TEST_F(VelocityTest, DeepOrbitsAreCirclesThatShrink) {
  const SingleWave deep = wave(std::numeric_limits<double>::infinity());
  Ocean sea = sea_of(deep);
  sea.at(3.0);
  const double amplitude_m = std::sqrt(2.0 * mean_square(sea.read_surface(0).displacement_y));
  for (const double depth_m : {0.0, 1.0, 10.0, 40.0}) {
    const VelocityFields velocity = sea.read_velocity(0, depth_m);
    const double expected = amplitude_m * deep.omega_radps() * std::exp(-deep.wavenumber_radpm() * depth_m);
    EXPECT_NEAR(vertical(velocity) / expected, 1.0, 1e-5) << depth_m;
    EXPECT_NEAR(horizontal(velocity) / expected, 1.0, 1e-5) << depth_m;
  }
}

// Fails if water flows through the bed, or if the horizontal motion there is lost: u = A w / sinh kD.
TEST_F(VelocityTest, FlowsAlongTheBed) {
  for (const double bed_m : {0.5, 5.0, 20.0}) {
    const SingleWave shallow = wave(bed_m);
    const double k = shallow.wavenumber_radpm();
    Ocean sea = sea_of(shallow);
    sea.at(3.0);
    const double speed =
        std::sqrt(2.0 * mean_square(sea.read_surface(0).displacement_y)) * shallow.omega_radps();
    const VelocityFields at_bed = sea.read_velocity(0, bed_m);
    // Exactly 0 before the transform, which it shares with the pressure head, A / cosh kD: rounding of the
    // one reaches the other, 2^-24 for each of some ten steps.
    EXPECT_LT(vertical(at_bed), 1e-6 * speed / shallow.omega_radps() / std::cosh(k * bed_m));
    EXPECT_NEAR(horizontal(at_bed) / (speed / std::sinh(k * bed_m)), 1.0, 1e-5) << bed_m;
    const VelocityFields middle = sea.read_velocity(0, 0.5 * bed_m);
    EXPECT_NEAR(horizontal(middle) / vertical(middle), 1.0 / std::tanh(0.5 * k * bed_m),
                1e-5 / std::tanh(0.5 * k * bed_m))
        << bed_m;
  }
}

// Fails if signs or depth factors make water appear or spin: the divergence and both vertical components of
// the rotation vanish. Depth derivatives by central differences over 2 x 0.1 m (d grows downward: d/dy =
// -d/dd), truncation (k dd)^2 / 6 = 3e-5, rounding 1e-6 / (k dd) = 1e-5; horizontal derivatives of a sinusoid
// are those of its quarter-wave neighbours, so all are compared by amplitude and phase over the patch.
TEST_F(VelocityTest, NeitherSpringsNorWhirls) {
  const SingleWave shallow = wave(8.0);
  const double step_radpm = 2.0 * std::numbers::pi / shallow.patch_length_m;
  const double kx = shallow.column * step_radpm, kz = shallow.row * step_radpm;
  Ocean sea = sea_of(shallow);
  sea.at(3.0);
  const double depth_m = 3.0, dd_m = 0.1;
  const VelocityFields above = sea.read_velocity(0, depth_m - dd_m);
  const VelocityFields below = sea.read_velocity(0, depth_m + dd_m);
  const VelocityFields here = sea.read_velocity(0, depth_m);
  double springs = 0.0, whirls = 0.0, scale = 0.0;
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      // A wave of K = (2, -1) moves by a quarter when x grows by L / 8: there it has its derivative over k_x.
      const auto i = static_cast<std::size_t>(row * size + column);
      const auto ahead = static_cast<std::size_t>(row * size + (column + size / 8) % size);
      const auto rate_of_depth = [&](const std::vector<float>& up, const std::vector<float>& down) {
        return (up[i] - down[i]) / (2.0 * dd_m);
      };
      const double divergence = kx * here.x[ahead] + kz * here.z[ahead] + rate_of_depth(above.y, below.y);
      const double about_z = rate_of_depth(above.x, below.x) - kx * here.y[ahead];
      const double about_x = rate_of_depth(above.z, below.z) - kz * here.y[ahead];
      springs += divergence * divergence;
      whirls += about_z * about_z + about_x * about_x;
      scale += std::pow(shallow.wavenumber_radpm() * here.y[i], 2.0);
    }
  }
  EXPECT_LT(std::sqrt(springs / scale), 2e-4);
  EXPECT_LT(std::sqrt(whirls / scale), 2e-4);
}

}  // namespace
}  // namespace offing::ocean
