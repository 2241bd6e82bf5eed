// Motion of clouds (C4, C15): closed forms, streamlines, and no history.
#include "host/clouds/particles/particle_motion.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/clouds/particles/cloud_model.h"
#include "tests/clouds/reference_density.h"

namespace offing::clouds {
namespace {

/// A lattice of particles of two masses around the origin.
std::vector<CloudParticle> lattice() {
  std::vector<CloudParticle> particles;
  for (int i = 0; i < 11 * 11 * 11; ++i) {
    CloudParticle particle{};
    particle.x = static_cast<float>(i % 11 - 5) * 40.0f;
    particle.y = static_cast<float>(i / 11 % 11 - 5) * 40.0f;
    particle.z = static_cast<float>(i / 121 - 5) * 40.0f;
    particle.radius = 10.0f;
    particle.optical_mass = i % 2 == 0 ? 8.0f : 2.0f;
    particle.id = static_cast<std::uint32_t>(i);
    particles.push_back(particle);
  }
  return particles;
}

glm::dvec3 place_of(const CloudParticle& particle) {
  return {particle.x, particle.y, particle.z};
}

class ParticleMotionTest : public testing::Test {
 protected:
  std::vector<CloudParticle> at(const CloudParameters& parameters, double time_s,
                                const glm::dvec3& origin_m = glm::dvec3(0.0)) const {
    CloudModel model(device_, parameters, rest_);
    model.at(time_s, origin_m);
    return model.particles().read();
  }

  const ocl::Device device_ = ocl::Device::open();
  const std::vector<CloudParticle> rest_ = lattice();
};

// Fails if wind, shear or drag act otherwise than their units say. Floats of some 1e4 m: 1e-3 m.
TEST_F(ParticleMotionTest, WindDriftsLeansAndDrags) {
  CloudParameters cloud;
  cloud.position_m = {1e6, 1000.0, -2e6};
  cloud.motion.wind_mps = {6.0, 0.0, 8.0};
  cloud.motion.shear_per_s = 0.01;
  cloud.motion.shear_lasts_s = 300.0;
  cloud.motion.drag = 4.0;
  const auto moved = at(cloud, 500.0, cloud.position_m);
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const double thin = rest_[i].optical_mass < 4.0f ? 0.75 : 0.0;
    const double along_m = 500.0 * 10.0 +
                           0.01 * 300.0 * std::tanh(5.0 / 3.0) * static_cast<double>(rest_[i].y) +
                           4.0 * 10.0 * thin;
    const glm::dvec3 expected_m = place_of(rest_[i]) + along_m * glm::dvec3(0.6, 0.0, 0.8);
    ASSERT_LT(glm::distance(place_of(moved[i]), expected_m), 2e-3);
  }
}

TEST_F(ParticleMotionTest, FollowsAPathOfKeys) {
  CloudParameters cloud;
  cloud.motion.wind_mps = {6.0, 0.0, 8.0};
  cloud.motion.path = {{{{{0.0, 0.0}, {10.0, 100.0}}}, {{{0.0, 500.0}}}, {{{0.0, -4.0}, {10.0, 6.0}}}}};
  EXPECT_LT(glm::distance(cloud_origin_m(cloud, 5.0), glm::dvec3(50.0, 500.0, 1.0)), 1e-9);
  const auto moved = at(cloud, 5.0);
  EXPECT_LT(glm::distance(place_of(moved[0]), place_of(rest_[0]) + glm::dvec3(50.0, 500.0, 1.0)), 1e-3);
}

// Fails if a time depends on what was asked for before.
TEST_F(ParticleMotionTest, AnyTimeIsReachedAtOnce) {
  CloudParameters cloud;
  cloud.motion = {.wind_mps = {3.0, 0.0, 1.0}, .shear_per_s = 0.01, .drag = 2.0, .sway_m = 30.0};
  cloud.motion.heat = CloudHeat{};
  cloud.motion.obstacle = CloudObstacle{{900.0, 0.0, 300.0}, 150.0};
  cloud.turbulence.change_per_s = 0.01;
  CloudModel model(device_, cloud, rest_);
  for (const double time_s : {0.0, 1e5, -20.0, 700.0}) model.at(time_s);
  model.at(300.0);
  const auto found = model.particles().read(), expected = at(cloud, 300.0);
  EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(CloudParticle)), 0);
}

// Fails if eddies are not the noise that they are said to be. Bound: 2^-23 of places of 1 wavelength, times a
// slope of 4 deviations: 1e-4 m of 30; measured 6e-5. Gate 1e-3.
TEST_F(ParticleMotionTest, EddiesAreGradientNoise) {
  CloudParameters cloud;
  cloud.seed = 77;
  cloud.motion.sway_m = 30.0;
  cloud.turbulence.wavelength_m = 170.0;
  cloud.turbulence.change_per_s = 0.01;
  const auto moved = at(cloud, 234.0);
  double squares = 0.0;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const glm::dvec3 place = place_of(rest_[i]) / 170.0, shift_m = place_of(moved[i]) - place_of(rest_[i]);
    for (int axis = 0; axis < 3; ++axis) {
      const double expected =
          30.0 / 0.169 * reference_noise(77, 13 + axis, {place.x, place.y, place.z, 2.34});
      ASSERT_NEAR(shift_m[axis], expected, 1e-3);
    }
    squares += glm::dot(shift_m, shift_m) / 3.0;
  }
  // 13 independent values an axis and octave: within a third.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(rest_.size())), 30.0, 12.0);
}

// Fails if the closed form is not the solution of its equation: against Runge and Kutta's method in steps of
// 0.1 s, whose error is 1e-9 of the lift.
TEST_F(ParticleMotionTest, LiftSolvesItsEquation) {
  const CloudHeat heat{.begins_s = 50.0, .excess_k = 1.5, .cooling_s = 900.0};
  struct State {
    double z, v;
  };
  const auto rate = [&](double t, const State& s) {
    const double force = 9.81 / 280.0 * heat.excess_k * std::exp(-t / heat.cooling_s);
    return State{s.v,
                 force - 2.0 * heat.damping_per_s * s.v - heat.stability_per_s * heat.stability_per_s * s.z};
  };
  State state{0.0, 0.0};
  constexpr double step = 0.1;
  for (int i = 0; i < 20'000; ++i) {
    if (i % 1000 == 0) {
      EXPECT_NEAR(lift_m(heat, 50.0 + i * step), state.z, 1e-5) << i;
    }
    const State a = rate(i * step, state);
    const State b = rate((i + 0.5) * step, {state.z + 0.5 * step * a.z, state.v + 0.5 * step * a.v});
    const State c = rate((i + 0.5) * step, {state.z + 0.5 * step * b.z, state.v + 0.5 * step * b.v});
    const State d = rate((i + 1.0) * step, {state.z + step * c.z, state.v + step * c.v});
    state.z += step / 6.0 * (a.z + 2.0 * b.z + 2.0 * c.z + d.z);
    state.v += step / 6.0 * (a.v + 2.0 * b.v + 2.0 * c.v + d.v);
  }
  EXPECT_EQ(lift_m(heat, 40.0), 0.0);
  EXPECT_GT(lift_m(heat, 350.0), 300.0);  // towards g dT / (T N^2) = 525 m
}

// Fails if a cloud does not form as it rises above the level of condensation, or stays when it sinks again.
TEST_F(ParticleMotionTest, WarmAirFormsACloudThatDissolves) {
  CloudParameters cloud;
  cloud.motion.heat = CloudHeat{.excess_k = 3.0, .condensation_m = 250.0};
  const auto mass_at = [&](double time_s) {
    double sum = 0.0;
    for (const CloudParticle& particle : at(cloud, time_s)) sum += static_cast<double>(particle.optical_mass);
    return sum;
  };
  const double all = 8.0 * 666 + 2.0 * 665;
  EXPECT_EQ(mass_at(-10.0), 0.0);  // all of it lies below 200 m
  EXPECT_GT(mass_at(400.0), 0.9 * all);
  EXPECT_LT(mass_at(4000.0), 0.5 * all);
  EXPECT_EQ(mass_at(20'000.0), 0.0);
}

// Fails if a cloud is carried through a sphere or otherwise around it than potential flow is: Stokes'
// function keeps its value along the wind, and nothing is inside. Floats of 1e3 m at 1e-7: 1e-4 of a radius.
TEST_F(ParticleMotionTest, FlowsAroundASphere) {
  CloudParameters cloud;
  cloud.motion.wind_mps = {10.0, 0.0, 0.0};
  cloud.motion.obstacle = CloudObstacle{{1000.0, 20.0, -30.0}, 120.0};
  for (const double time_s : {0.0, 80.0, 100.0, 130.0, 1000.0}) {
    const auto moved = at(cloud, time_s, cloud.motion.obstacle->centre_m);
    double farthest = 0.0;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const glm::dvec3 from =
          (place_of(rest_[i]) + glm::dvec3(10.0 * time_s, 0.0, 0.0) - cloud.motion.obstacle->centre_m) /
          120.0;
      const glm::dvec3 found = place_of(moved[i]) / 120.0;
      const double r = glm::length(found), square = found.y * found.y + found.z * found.z;
      ASSERT_GE(r, 1.0 - 1e-4);
      ASSERT_NEAR(found.x, from.x, 1e-4);
      ASSERT_NEAR(square * (1.0 - 1.0 / (r * r * r)), from.y * from.y + from.z * from.z, 2e-4);
      farthest = std::max(farthest, glm::distance(found, from));
    }
    if (time_s == 1000.0) {  // 75 radii downstream
      EXPECT_LT(farthest, 1e-3);
    }
    if (time_s == 100.0) {
      EXPECT_GT(farthest, 0.5);
    }
  }
}

// Fails if a cloud flows around a sphere along its wind and not along its path, or if one that stands still
// is inflated: it was a shell around the sphere in both cases. As FlowsAroundASphere, in turned axes.
TEST_F(ParticleMotionTest, FlowsAroundASphereAlongItsPath) {
  CloudParameters cloud;
  cloud.motion.obstacle = CloudObstacle{{0.0, 20.0, -30.0}, 120.0};
  cloud.motion.path = {{{{{0.0, -30.0}, {100.0, 30.0}}, Interpolation::linear},
                        {{{0.0, 0.0}}, Interpolation::linear},
                        {{{0.0, -40.0}, {100.0, 40.0}}, Interpolation::linear}}};
  const glm::dvec3 along(0.6, 0.0, 0.8);
  const auto moved = at(cloud, 40.0, cloud.motion.obstacle->centre_m);
  double farthest = 0.0;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const glm::dvec3 from =
        (place_of(rest_[i]) + cloud_origin_m(cloud, 40.0) - cloud.motion.obstacle->centre_m) / 120.0;
    const glm::dvec3 found = place_of(moved[i]) / 120.0;
    ASSERT_GE(glm::length(found), 1.0 - 1e-4);
    ASSERT_NEAR(glm::dot(found, along), glm::dot(from, along), 1e-4);
    farthest = std::max(farthest, glm::distance(found, from));
  }
  EXPECT_GT(farthest, 0.3);
  cloud.motion.path.reset();
  const auto still = at(cloud, 40.0);
  for (std::size_t i = 0; i < rest_.size(); ++i) ASSERT_EQ(place_of(still[i]), place_of(rest_[i]));
}

}  // namespace
}  // namespace offing::clouds
