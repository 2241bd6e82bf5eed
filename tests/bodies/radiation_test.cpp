// Added mass and the memory of waves made: against Capytaine and closed forms.
#include "host/bodies/radiation.h"

#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/bodies/floating_bodies.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

constexpr std::size_t heave = 1 * hull_motions + 1;

// Heave of a 10 m cube, draught 5 m: Capytaine 3.0, 12 x 12 faces a side. A value of an irregular frequency,
// at 2.1 rad/s, is left out.
constexpr double cube_frequencies_radps[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0,
                                             1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0,
                                             2.2, 2.3, 2.4, 2.5, 2.6, 2.7, 2.8, 2.9, 3.0};
constexpr double cube_added_kg[] = {
    427590.0, 433960.0, 434690.0, 427250.0, 411950.0, 391090.0, 367870.0, 345320.0, 325840.0, 310710.0,
    300440.0, 294630.0, 292510.0, 293150.0, 295520.0, 298820.0, 302450.0, 305980.0, 309150.0, 311610.0,
    318500.0, 319650.0, 320950.0, 322110.0, 323110.0, 323970.0, 324700.0, 325340.0, 325890.0};
constexpr double cube_damping_kgps[] = {
    519.41,  3924.2,  12017.0, 24819.0, 40604.0, 56617.0, 70072.0, 78917.0, 82243.0, 80160.0,
    73708.0, 64331.0, 53553.0, 42781.0, 32884.0, 24421.0, 17547.0, 12266.0, 8361.3,  5541.3,
    1888.3,  1214.5,  692.49,  376.44,  193.47,  91.57,   36.537,  9.3109,  0.0};
constexpr double cube_added_at_infinity_kg = 332420.0;

/// Of a cube of this side, by Froude's law.
HydrodynamicData heave_of_cube(double side_m) {
  const double scale = side_m / 10.0, volume = scale * scale * scale;
  HydrodynamicData data;
  data.source = "heave of a cube";
  for (std::size_t i = 0; i < std::size(cube_frequencies_radps); ++i) {
    data.frequencies_radps.push_back(cube_frequencies_radps[i] / std::sqrt(scale));
    data.added_mass.emplace_back()[heave] = volume * cube_added_kg[i];
    data.damping.emplace_back()[heave] = volume / std::sqrt(scale) * cube_damping_kgps[i];
  }
  data.added_mass_at_infinity[heave] = volume * cube_added_at_infinity_kg;
  return data;
}

/// A body that water neither drags nor damps but by its data.
FloatingBody smooth_cube(double side_m) {
  FloatingBody body = load_to_level("cube", test::box(glm::dvec3(side_m)), 0.0, test::sea_density_kgpm3);
  body.drag = {.face = 0.0, .wake = 0.0};
  body.hydrodynamics = std::make_shared<const HydrodynamicData>(heave_of_cube(side_m));
  body.start = at_rest(body, test::sea_density_kgpm3, 0.0, 0.0, 0.0);
  return body;
}

class RadiationTest : public testing::Test {
 protected:
  const ocl::Device device_ = ocl::Device::open();
};

// Fails if the memory is not that of the damping: A(omega) = A(inf) - 1 / omega integral of K sin(omega t)
// (Ogilvie 1964) is a further result of Capytaine's. Frequencies of 0.1 rad/s are linear between: gate 2 %.
TEST(HullMemoryTest, GivesTheAddedMassOfOtherFrequencies) {
  const HullMemory found = memory_of_hull(heave_of_cube(10.0), glm::dvec3(0.0), 10.0, 120.0);
  const double sample_s = found.steps_a_sample / 120.0;
  for (const std::size_t i : {4, 7, 9, 12, 16}) {
    const double frequency_radps = cube_frequencies_radps[i];
    double added_kg = cube_added_at_infinity_kg;
    for (std::size_t n = 1; n < found.memory.size(); ++n) {
      added_kg -= found.memory[n][heave] * std::sin(frequency_radps * sample_s * static_cast<double>(n)) /
                  frequency_radps;
    }
    EXPECT_NEAR(added_kg, cube_added_kg[i], 0.02 * cube_added_kg[i]) << frequency_radps;
  }
}

// Fails if a matrix about another point has another energy for the same motion of a rigid body.
TEST(HullMemoryTest, MovesToTheMassCentre) {
  HullMatrix matrix{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      matrix[i * 6 + j] = (i == j ? 10.0 : 0.0) + std::cos(static_cast<double>(i * j));
    }
  }
  const glm::dvec3 arm_m(1.5, -2.0, 0.7), velocity(0.3, -1.0, 2.0), spin(0.9, 0.4, -0.8);
  const auto energy = [](const HullMatrix& mass, const glm::dvec3& along, const glm::dvec3& about) {
    const double motions[] = {along.x, along.y, along.z, about.x, about.y, about.z};
    double sum = 0.0;
    for (std::size_t i = 0; i < 36; ++i) sum += 0.5 * mass[i] * motions[i / 6] * motions[i % 6];
    return sum;
  };
  EXPECT_NEAR(energy(about_another_point(matrix, arm_m), velocity + glm::cross(spin, arm_m), spin),
              energy(matrix, velocity, spin), 1e-10);
}

// Fails if tables that do not fit each other, or values that are no numbers, are taken.
TEST(HullMemoryTest, RefusesBadData) {
  HydrodynamicData data = heave_of_cube(10.0);
  data.damping.pop_back();
  EXPECT_THROW(memory_of_hull(data, glm::dvec3(0.0), 10.0, 120.0), Error);
  data = heave_of_cube(10.0);
  data.damping[3][heave] = std::nan("");
  EXPECT_THROW(memory_of_hull(data, glm::dvec3(0.0), 10.0, 120.0), Error);
  data = heave_of_cube(10.0);
  data.frequencies_radps[1] = data.frequencies_radps[0];
  EXPECT_THROW(memory_of_hull(data, glm::dvec3(0.0), 10.0, 120.0), Error);
}

// Fails if a cube that is let go does not heave as linear theory has it, by a Fourier integral of the data's
// response (m = 512.5 t, waterplane 100 m^2), or a small cube does not by Froude's law. The widest error is
// that of steps and samples: 1 % of the release.
TEST_F(RadiationTest, CubesHeaveAsLinearTheoryHasIt) {
  constexpr double expected[] = {1.0,    0.4641, -0.5457, -0.9248, -0.3058, 0.5793,
                                 0.7687, 0.1235, -0.593,  -0.6095, 0.0283};
  for (const double side_m : {10.0, 0.3}) {
    FloatingBody body = smooth_cube(side_m);
    const double rest_m = body.start.mass_centre_m.y, release_m = 0.01 * side_m;
    body.start.mass_centre_m.y += release_m;
    FloatingBodies floating(device_, {body});
    for (std::size_t i = 0; i < std::size(expected); ++i) {
      floating.advance_to(static_cast<double>(i) * std::sqrt(side_m / 10.0), test::still_water());
      const double found = (floating.read_poses().front().mass_centre_m.y - rest_m) / release_m;
      EXPECT_NEAR(found, expected[i], side_m > 1.0 ? 0.01 : 0.03) << side_m << " m, " << i;
    }
  }
}

// Fails if a body does not begin to turn across its way by Munk's moment, (A_zz - A_xx) u w, within 1 %, or
// gains energy as it tumbles under water.
TEST_F(RadiationTest, TumblesUnderWaterWithoutGain) {
  FloatingBody body = load_to_mass("box", test::box({4.0, 2.0, 3.0}), 0.999 * test::sea_density_kgpm3 * 24.0,
                                   test::sea_density_kgpm3, 0.0);
  body.mass_kg = test::sea_density_kgpm3 * 24.0;
  body.mass_centre_m = glm::dvec3(0.0);
  body.drive.rudder_area_m2 = 0.0;
  body.drag = {.face = 0.0, .wake = 0.0};
  HydrodynamicData data;
  data.source = "box";
  data.frequencies_radps = {1.0, 2.0};
  data.damping.resize(2);
  const double added[] = {0.2, 1.0, 0.7, 0.1, 0.3, 0.5};
  for (std::size_t i = 0; i < 6; ++i) {
    const double own =
        i < 3 ? body.mass_kg : body.inertia_kgm2[static_cast<int>(i) - 3][static_cast<int>(i) - 3];
    data.added_mass_at_infinity[7 * i] = added[i] * own;
  }
  body.hydrodynamics = std::make_shared<const HydrodynamicData>(data);
  body.start.mass_centre_m.y = -500.0;
  body.start.velocity_mps = {2.0, 0.0, 1.0};
  const auto energy = [&](const BodyPose& pose) {
    const glm::dvec3 velocity = glm::conjugate(pose.turn) * pose.velocity_mps;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
      sum += 0.5 * body.mass_kg * (1.0 + added[i]) * velocity[i] * velocity[i] +
             0.5 * body.inertia_kgm2[i][i] * (1.0 + added[i + 3]) * pose.spin_radps[i] * pose.spin_radps[i];
    }
    return sum;
  };
  FloatingBodies turning(device_, {body});
  turning.advance_to(0.05, test::still_water());
  const double gain = 0.5 * body.mass_kg * 2.0 * 1.0 / (1.3 * body.inertia_kgm2[1][1]);
  EXPECT_NEAR(turning.read_poses().front().spin_radps.y, 0.05 * gain, 0.01 * 0.05 * gain);

  // Explicit steps at 5 rad/s would gain 2 % a radian; friction takes less than 1 %.
  body.start.spin_radps = {3.0, 4.0, 1.0};
  FloatingBodies tumbling(device_, {body});
  double last = energy(body.start);
  for (int frame = 1; frame <= 90; ++frame) {
    tumbling.advance_to(frame / 30.0, test::still_water());
    const double now = energy(tumbling.read_poses().front());
    EXPECT_LE(now, last * (1.0 + 1e-5)) << frame;
    EXPECT_GE(now, last * 0.99) << frame;
    last = now;
  }
}

// Fails if where a body with a memory is depends on which times were asked for, or on an earlier run.
TEST_F(RadiationTest, StatesDoNotDependOnTheFrames) {
  FloatingBody body = smooth_cube(10.0);
  body.start.mass_centre_m.y += 0.5;
  FloatingBodies at_once(device_, {body}), by_frames(device_, {body});
  at_once.advance_to(4.0, test::still_water());
  by_frames.advance_to(1.0, test::still_water());
  by_frames.reset(0.0);
  for (int frame = 1; frame <= 60; ++frame) by_frames.advance_to(frame / 15.0, test::still_water());
  const std::vector<BodyState> expected = at_once.path().read(), found = by_frames.path().read();
  EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(BodyState)), 0);
}

}  // namespace
}  // namespace offing::bodies
