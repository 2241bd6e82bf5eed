#include "host/world/cloud_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace offing::world {
namespace {

const ocl::Device& device() {
  static const ocl::Device opened = ocl::Device::open();
  return opened;
}

// Higher up there is less air above a cloud: more sun, and less sky, whatever the sun's height. Fails if a
// cloud is lit as the eye or the ground is.
TEST(CloudLight, IsThatOfItsAltitude) {
  const sky::Atmosphere air;
  sky::ClearSky sky(device(), air);
  const sky::Sun sun{.sun_direction = {0.8, 0.6, 0.0}};
  const double altitudes_m[] = {10.0, 9000.0};
  const auto lights = cloud_illumination(sky, air, sun, altitudes_m);
  const clouds::CloudIllumination &low = lights.at(0), &high = lights.at(1);
  ASSERT_EQ(low.suns.size(), 1u);
  EXPECT_GT(high.suns[0].illuminance_klx.z, 1.05 * low.suns[0].illuminance_klx.z);
  EXPECT_LT(high.sky_kcdpm2.z, 0.8 * low.sky_kcdpm2.z);
  EXPECT_EQ(high.ground_kcdpm2, low.ground_kcdpm2);
  EXPECT_GT(low.ground_kcdpm2.x, 0.0);
  // At night there is no sun.
  for (const auto& light : cloud_illumination(sky, air, {.sun_direction = {0.8, -0.6, 0.0}}, altitudes_m))
    EXPECT_TRUE(light.suns.empty());
}

// Fails if the light between two steps of altitude is another than that which the sky has there: half way,
// with the sun 12 degrees high. Gate 2 %.
TEST(CloudLight, IsMixedBetweenStepsOfAltitude) {
  const sky::Atmosphere air;
  sky::ClearSky sky(device(), air);
  const std::array<double, 3> toward_sun{0.978, 0.2079, 0.0};
  const double altitudes_m[] = {250.0, 750.0, 3250.0};
  const auto lights = cloud_illumination(sky, air, {.sun_direction = toward_sun}, altitudes_m);
  double most = 0.0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    sky.at({.sun_direction = toward_sun}, altitudes_m[i]);
    const sky::Illuminance exact = sky.read_illuminance();
    for (int colour = 0; colour < 3; ++colour) {
      const auto c = static_cast<std::size_t>(colour);
      most = std::max({most, std::abs(lights[i].suns.at(0).illuminance_klx[colour] / exact.sun_klx[c] - 1.0),
                       std::abs(lights[i].sky_kcdpm2[colour] * std::numbers::pi / exact.sky_klx[c] - 1.0)});
    }
  }
  RecordProperty("most", std::to_string(most));
  EXPECT_LT(most, 0.02);
}

// Fails if a light does not light clouds, comes from elsewhere, takes the sun's place in front, or if more of
// them are taken than kernels have room for.
TEST(CloudLight, HasTheLightsBesideTheSun) {
  const std::vector<glm::dvec3> places_m{{0.0, 1000.0, 0.0}, {300.0, 1000.0, 0.0}};
  const clouds::CloudLight sun{.direction = {0.8, 0.6, 0.0}, .illuminance_klx = glm::dvec3(90.0)};
  const std::vector<clouds::CloudIllumination> sunlit{{.suns = {sun}},
                                                      {.suns = {}}};  // one of them in the dark
  using Kind = highlights::Source::Kind;
  const std::vector<Light> lights{
      {.source = {Kind::place, {300.0, 600.0, 0.0}}, .colour = {1.0, 0.5, 0.0}, .illuminance_klx = 40.0},
      {.source = {Kind::direction, {0.0, 0.0, -2.0}}, .illuminance_klx = 8.0},
      {.source = {Kind::direction, {1.0, 0.0, 0.0}}, .illuminance_klx = 0.0},
      {.source = {Kind::direction, {1.0, 0.0, 0.0}}, .illuminance_klx = 30.0}};
  const auto lit = with_lights(sunlit, lights, places_m);
  const clouds::CloudLight near_first{.direction = {0.6, -0.8, 0.0}, .illuminance_klx = {40.0, 20.0, 0.0}};
  const clouds::CloudLight near_second{.direction = {0.0, -1.0, 0.0}, .illuminance_klx = {40.0, 20.0, 0.0}};
  const clouds::CloudLight far{.direction = {0.0, 0.0, -1.0}, .illuminance_klx = glm::dvec3(8.0)};
  ASSERT_EQ(lit.at(0).suns.size(), 3u);
  EXPECT_EQ(lit[0].suns[0], sun);
  EXPECT_LT(glm::length(lit[0].suns[1].direction - near_first.direction), 1e-12);
  EXPECT_EQ(lit[0].suns[1].illuminance_klx, near_first.illuminance_klx);
  EXPECT_EQ(lit[0].suns[2], far);
  EXPECT_EQ(lit.at(1).suns, (std::vector{clouds::CloudLight{}, near_second, far}));
  EXPECT_EQ(with_lights(sunlit, {}, places_m), sunlit);
}

}  // namespace
}  // namespace offing::world
