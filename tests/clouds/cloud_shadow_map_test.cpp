#include "host/clouds/light/cloud_shadow_map.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/reference/scattering_medium.h"
#include "tests/clouds/example_clouds.h"

namespace offing::clouds {
namespace {

class CloudShadowMapTest : public testing::Test {
 protected:
  /// Depth of the texel over a place, all of it, as cloud_shadow_depth() has it far below the clouds.
  double depth_over(const glm::dvec3& place) const {
    const CloudShadowParams& p = shadow_.params();
    const glm::dvec3 from = place - glm::dvec3(p.middle_x, p.middle_y, p.middle_z);
    const double texel = 2.0 * p.half_width / CLOUD_SHADOW_SIZE;
    const double x = (glm::dot(from, glm::dvec3(p.right_x, p.right_y, p.right_z)) + p.half_width) / texel;
    const double y = (glm::dot(from, glm::dvec3(p.up_x, p.up_y, p.up_z)) + p.half_width) / texel;
    return shadow_.map()
        .map()[static_cast<std::size_t>(y) * CLOUD_SHADOW_SIZE + static_cast<std::size_t>(x)][0];
  }

  const ocl::Device device_ = ocl::Device::open();
  const std::vector<CloudParticle> particles_ = test::heap({.count = 50, .extinction_per_m = 0.004});
  const ocl::Buffer<CloudParticle> buffer_{device_, particles_, "particles"};
  CloudShadowMap shadow_{device_};
  const glm::dvec3 sun_ = glm::normalize(glm::dvec3(0.3, 1.0, -0.4));
};

// Fails if the light that reaches a place is wrong: beside the midpoint rule over h in double precision,
// below, inside and above the cloud. Single precision chords: measured 2e-6; gate 1e-4.
TEST_F(CloudShadowMapTest, PlacesGetWhatChordsLeave) {
  shadow_.update(buffer_, 50, sun_, {0.0, 0.0, 0.0}, 1000.0);
  std::vector<glm::vec3> places;
  for (int i = 0; i < 40; ++i)
    places.emplace_back(25.0f * static_cast<float>(i) - 500.0f, 400.0f - 40.0f * static_cast<float>(i % 20),
                        13.0f * static_cast<float>(i % 7));
  const std::vector<float> found = shadow_.transmittance(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    double depth = 0.0;
    for (const CloudParticle& particle : particles_) {
      const double radius = particle.radius,
                   middle = particle.optical_mass / (0.815595 * radius * radius * radius);
      for (int step = 0; step < 1500; ++step) {
        const glm::dvec3 way = glm::dvec3(places[i]) + (step + 0.5) * 1.0 * sun_ -
                               glm::dvec3(particle.x, particle.y, particle.z);
        const double r2 = glm::dot(way, way) / (radius * radius);
        if (r2 < 1.0) depth += middle * (1.0 + r2 * (-22.0 + r2 * (17.0 - 4.0 * r2)) / 9.0);
      }
    }
    EXPECT_NEAR(found[i], std::exp(-depth), 1e-4) << i;
  }
}

// Fails if the map says otherwise than the exact chords: below the clouds, texels of 4 m are read without
// mixing, half a texel away where depth changes by at most 0.02 a metre. And none of it is lost: the sum over
// texels is the optical mass.
TEST_F(CloudShadowMapTest, MapHasTheDepthOfTheClouds) {
  shadow_.update(buffer_, 50, sun_, {0.0, 0.0, 0.0}, 1000.0);
  std::vector<glm::vec3> places;
  for (int i = 0; i < 30; ++i)
    places.emplace_back(30.0f * static_cast<float>(i) - 450.0f, -900.0f,
                        17.0f * static_cast<float>(i) + 20.0f);
  const std::vector<float> exact = shadow_.transmittance(places);
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_NEAR(depth_over(places[i]), -std::log(exact[i]), 0.08) << i;
  double sum = 0.0, mass = 0.0;
  for (const CloudShadowMap::Texel& texel : shadow_.map().read()) sum += texel[0];
  for (const CloudParticle& particle : particles_) mass += particle.optical_mass;
  EXPECT_NEAR(sum * std::pow(2000.0 / CLOUD_SHADOW_SIZE, 2) / mass, 1.0, 2e-3);
}

// Fails if sums of deep particles leave their integers: depths became negative, and the sea below them black
// or no number. Beside the shadow nothing changes.
TEST_F(CloudShadowMapTest, StaysFiniteBelowOpaqueStacks) {
  std::vector<CloudParticle> stack;
  for (int i = 0; i < 3000; ++i) {
    CloudParticle opaque = particles_.front();
    opaque.x = opaque.z = 0.0f;
    opaque.y = static_cast<float>(i);
    opaque.radius = 100.0f;
    opaque.optical_mass = 1e9f;
    stack.push_back(opaque);
  }
  const ocl::Buffer<CloudParticle> buffer(device_, stack, "particles");
  shadow_.update(buffer, 3000, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, 1000.0);
  // A particle counts up to a depth of 64.
  EXPECT_NEAR(depth_over({0.0, -900.0, 0.0}), 3000.0 * 64.0, 3000.0);
  EXPECT_EQ(depth_over({500.0, -900.0, 0.0}), 0.0);
  for (const CloudShadowMap::Texel& texel : shadow_.map().read()) {
    ASSERT_GE(texel[0], 0.0f);
    ASSERT_TRUE(std::isfinite(texel[1]) && std::abs(texel[1]) < 4.0f);
    ASSERT_TRUE(std::isfinite(texel[2]));
  }
}

// Fails if a wrong argument is taken, or if nothing throws a shadow.
TEST_F(CloudShadowMapTest, RefusesWhatHasNoShadow) {
  EXPECT_THROW(shadow_.update(buffer_, 51, sun_, {}, 1000.0), Error);
  EXPECT_THROW(shadow_.update(buffer_, 50, 2.0 * sun_, {}, 1000.0), Error);
  EXPECT_THROW(shadow_.update(buffer_, 50, sun_, {}, 0.0), Error);
  shadow_.update(buffer_, 0, sun_, {}, 1000.0);
  EXPECT_EQ(shadow_.transmittance(std::vector<glm::vec3>{{0.0f, -900.0f, 0.0f}})[0], 1.0f);
  EXPECT_EQ(shadow_.map().read()[1000][0], 0.0f);
}

}  // namespace
}  // namespace offing::clouds
