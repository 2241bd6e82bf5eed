#include "host/clouds/light/light_of_others.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace offing::clouds {
namespace {

CloudExtent ellipsoid(const glm::dvec3& middle_m, const glm::dvec3& half_axes_m, double depth) {
  // Of the mean chord.
  return {middle_m, half_axes_m, depth * std::numbers::pi * half_axes_m.x * half_axes_m.z};
}

CloudLook white() {
  CloudLook look;
  look.albedo = glm::dvec3(1.0);
  return look;
}

CloudIllumination even_light() {
  CloudIllumination light;
  light.sky_kcdpm2 = light.ground_kcdpm2 = {3.0, 4.0, 5.0};
  return light;
}

std::vector<CloudIllumination> lit(const CloudIllumination& light, const std::vector<CloudExtent>& clouds) {
  const std::vector<CloudLook> looks(clouds.size(), white());
  return with_light_of_others(std::vector<CloudIllumination>(clouds.size(), light), clouds, looks);
}

// Where light is alike from all sides, clouds that lose none cannot be seen. Fails if they darken each other
// or make light.
TEST(LightOfOthersTest, KeepsEvenLight) {
  const auto lights = lit(even_light(), {ellipsoid({0, 0, 0}, {500, 300, 400}, 30.0),
                                         ellipsoid({900, 100, 0}, {500, 300, 400}, 5.0),
                                         ellipsoid({600, 0, 500}, {700, 200, 400}, 0.5)});
  for (const CloudIllumination& light : lights) {
    EXPECT_LT(glm::length(light.clouds_above_kcdpm2), 1e-12);
    EXPECT_LT(glm::length(light.clouds_below_kcdpm2), 1e-12);
  }
}

// A wide deep layer below gives the sun's light back: E sin(elevation) / pi, and as much of the sky's. It
// throws back 0.75 t / (1 + 0.75 t) of it, t the transport depth, and lies before all of the lower half but
// what is within a few degrees of level. Fails if light of the suns is lost or comes twice.
TEST(LightOfOthersTest, WideLayerGivesBackWhatItGets) {
  CloudIllumination light = even_light();
  light.ground_kcdpm2 = glm::dvec3(0.5);
  const double elevation_rad = 0.6;
  light.suns.push_back({{std::cos(elevation_rad), std::sin(elevation_rad), 0.0}, glm::dvec3(80.0)});
  const auto lights =
      lit(light, {ellipsoid({0, 0, 0}, {100, 100, 100}, 1e-6), ellipsoid({0, -400, 0}, {1e5, 50, 1e5}, 1e5)});
  const glm::dvec3 expected =
      80.0 * std::sin(elevation_rad) / std::numbers::pi + light.sky_kcdpm2 - light.ground_kcdpm2;
  for (int colour = 0; colour < 3; ++colour)
    EXPECT_NEAR(lights[0].clouds_below_kcdpm2[colour] / expected[colour], 1.0, 0.03) << colour;
  EXPECT_LT(glm::length(lights[0].clouds_above_kcdpm2), 1e-12);
  // What is thin before it is not seen.
  EXPECT_LT(glm::length(lights[1].clouds_above_kcdpm2), 1e-4);
}

CloudIllumination sun_overhead() {
  CloudIllumination light = even_light();
  light.ground_kcdpm2 = glm::dvec3(0.5);
  light.suns.push_back({{0.0, 1.0, 0.0}, glm::dvec3(80.0)});
  return light;
}

// Fails if a cloud alone, one without particles, or one far away changes anything; or if one nearer than ten
// times its size does not.
TEST(LightOfOthersTest, LeavesThoseAloneThatAreAlone) {
  const CloudExtent cloud = ellipsoid({0, 0, 0}, {500, 300, 400}, 30.0);
  const auto lit_beside = [&](std::vector<CloudExtent> clouds) {
    clouds.push_back(cloud);
    return lit(sun_overhead(), clouds).back();
  };
  EXPECT_EQ(lit_beside({}), sun_overhead());
  EXPECT_EQ(lit_beside({CloudExtent{}}), sun_overhead());
  EXPECT_EQ(lit_beside({ellipsoid({5001, 0, 0}, {500, 300, 400}, 30.0)}), sun_overhead());
  EXPECT_NE(lit_beside({ellipsoid({1500, 0, 0}, {500, 300, 400}, 30.0)}), sun_overhead());
}

// Under a wide deep cloud with the sun overhead a layer gets no sun: it shows the cloud what sky and ground
// give. Fails if clouds do not shade what they see.
TEST(LightOfOthersTest, CloudsShadeWhatTheySee) {
  const CloudExtent above = ellipsoid({0, 2000, 0}, {1e4, 200, 1e4}, 1e4),
                    below = ellipsoid({0, 0, 0}, {1e4, 200, 1e4}, 1e4);
  const auto lights = lit(sun_overhead(), {above, below});
  // The sun would give 80 / pi, 25. Most of what is seen below lies in shade.
  EXPECT_LT(lights[0].clouds_below_kcdpm2.y, 8.0);
  EXPECT_GT(lights[0].clouds_below_kcdpm2.y, 0.0);
}

CloudParticle particle_at(float x, float y, float z) {
  CloudParticle particle{};
  particle.x = x, particle.y = y, particle.z = z;
  particle.radius = 1.0f;
  particle.optical_mass = 2.0f;
  return particle;
}

// A ball of even density: its variance along an axis is R^2 / 5. Fails if the ellipsoid is not that of the
// particles, or if one that is not a number counts.
TEST(LightOfOthersTest, FindsExtents) {
  std::vector<CloudParticle> particles;
  for (float x = -10; x <= 10; ++x)
    for (float y = -10; y <= 10; ++y)
      for (float z = -10; z <= 10; ++z)
        if (x * x + y * y + z * z <= 100)
          particles.push_back(particle_at(7.0f + 20.0f * x, 10.0f * y, 10.0f * z));
  const double count = static_cast<double>(particles.size());
  particles.push_back(particle_at(NAN, 0.0f, 0.0f));
  const CloudExtent extent = extent_of(particles);
  EXPECT_NEAR(extent.middle_m.x, 7.0, 1e-6);
  EXPECT_NEAR(extent.half_axes_m.x, 200.0, 2.0);
  EXPECT_NEAR(extent.half_axes_m.y, 100.0, 1.0);
  EXPECT_NEAR(extent.optical_mass_m2, 2.0 * count, 1e-6 * count);
  EXPECT_EQ(extent_of({}), CloudExtent{});
}

}  // namespace
}  // namespace offing::clouds
