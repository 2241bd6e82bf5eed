#include "host/clouds/light/particle_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/clouds/example_clouds.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::clouds {
namespace {

/// Particles on a device, their light, and what is seen of them.
class LitCloud {
 public:
  LitCloud(std::vector<CloudParticle> particles, const CloudLook& look, const CloudIllumination& light,
           LightModel model = LightModel::calibrated)
      : particles_(std::move(particles)),
        buffer_(device_, particles_, "particles"),
        sprites_(device_, particles_.size(), "sprites") {
    light_.relight(buffer_, static_cast<std::uint32_t>(particles_.size()), light, std::span(&look, 1), model);
  }

  std::vector<CloudSprite> sprites(const glm::dvec3& eye_m) {
    light_.see(glm::vec3(eye_m), sprites_);
    return sprites_.read();
  }
  test::SpriteView view(const glm::dvec3& middle_m, double radius_m, const glm::dvec3& toward_eye,
                        int pixels = 96) {
    return test::view_of(particles_, sprites(middle_m + 1e5 * toward_eye), middle_m, radius_m, toward_eye,
                         pixels);
  }

 private:
  const ocl::Device device_ = ocl::Device::open();
  std::vector<CloudParticle> particles_;
  ocl::Buffer<CloudParticle> buffer_;
  ocl::Buffer<CloudSprite> sprites_;
  ParticleLight light_{device_};
};

CloudLook conservative(double g) {
  CloudLook look;
  look.phase = PhaseKind::henyey_greenstein;
  look.g = g;
  look.albedo = glm::dvec3(1.0);
  return look;
}

// Fails if light is made or lost: the same light from everywhere upon what only scatters is that light again.
// Multigrid leaves some of it out where thick billboards and gaps lie side by side. Measured 0.7 % (thick)
// and 2 % at worst.
TEST(ParticleLightTest, WhiteFurnaceIsWhite) {
  CloudIllumination light;
  light.sky_kcdpm2 = light.ground_kcdpm2 = glm::dvec3(1.0, 2.0, 3.0);
  for (const double extinction_per_m : {0.001, 0.02, 0.3}) {
    std::vector<CloudParticle> particles = test::heap({.extinction_per_m = extinction_per_m});
    for (CloudParticle& particle : particles) particle.red = particle.green = particle.blue = 1.0f;
    LitCloud cloud(particles, conservative(0.85), light);
    for (const CloudSprite& sprite : cloud.sprites({300.0, 900.0, 2000.0})) {
      ASSERT_NEAR(sprite.red, 1.0f, 0.03f) << extinction_per_m;
      ASSERT_NEAR(sprite.blue, 3.0f, 0.09f) << extinction_per_m;
    }
  }
}

// Share of sunlight from straight above that comes out below a layer of particles far from its rim, as
// billboards show it: the flux of their light, by directions that lie closer around the beam, and the beam
// itself.
double transmittance_of_layer(double depth, LightModel model) {
  const double pi = std::numbers::pi, half_width_m = 1350.0;
  CloudIllumination light;
  light.suns.push_back({{0.0, 1.0, 0.0}, glm::dvec3(1.0)});
  LitCloud cloud(test::layer(depth, half_width_m, 300.0, 37.5), conservative(0.85), light, model);
  constexpr int angles = 14;
  double flux = std::exp(-depth);
  for (int i = 0; i < angles; ++i) {
    const double u = (i + 0.5) / angles, angle = 0.5 * pi * u * u;
    // Beyond 75 degrees the middle would show the rim; for the 7 % of a hemisphere's flux there Eddington's
    // law of darkening, 1 + 3/2 cos, goes on from what is seen at 75.
    const double seen_angle = std::min(angle, 1.3);
    const double darkening = (1.0 + 1.5 * std::cos(angle)) / (1.0 + 1.5 * std::cos(seen_angle));
    const glm::dvec3 toward_eye(std::sin(seen_angle) * 0.8, -std::cos(seen_angle),
                                std::sin(seen_angle) * 0.6);
    const test::SpriteView view = cloud.view({0.0, 0.0, 0.0}, 400.0, toward_eye, 48);
    double light_sum = 0.0;
    int pixels = 0;
    for (int row = 22; row < 26; ++row)
      for (int column = 8; column < 40; ++column, ++pixels)
        light_sum += view.light[static_cast<std::size_t>(row * view.pixels + column)].x;
    flux += darkening * 2.0 * pi * light_sum / pixels * std::cos(angle) * std::sin(angle) * pi * u / angles;
  }
  return flux;
}

// Fails if thick clouds are too dark or too bright: transmittance of a conservative slab, g = 0.85, of what
// billboards show in the end, within 10 % of the truth. At 32 particles of
// one colour each show some 9 % too much, the worst of the five.
TEST(ParticleLightTest, LayersLetThroughWhatSlabsDo) {
  const double depths[] = {2.0, 4.0, 8.0, 16.0, 32.0}, truth[] = {0.909, 0.809, 0.642, 0.444, 0.274};
  for (int i = 0; i < 5; ++i) {
    const double found = transmittance_of_layer(depths[i], LightModel::calibrated);
    RecordProperty("transmittance_" + std::to_string(static_cast<int>(depths[i])), std::to_string(found));
    EXPECT_NEAR(found / truth[i], 1.0, 0.10) << depths[i] << ": " << found;
  }
}

// Fails if the paper's model keeps light that it should lose: below a layer of depth 8 its recurrence leaves
// .09 of the sun's light where .64 come through. Toward an eye at one angle below, measured 0.54 of the
// calibrated model's light.
TEST(ParticleLightTest, HarrisLosesLight) {
  CloudIllumination light;
  light.suns.push_back({{0.0, 1.0, 0.0}, glm::dvec3(1.0)});
  LitCloud harris(test::layer(8.0, 1000.0, 300.0, 100.0), conservative(0.85), light, LightModel::harris);
  LitCloud calibrated(test::layer(8.0, 1000.0, 300.0, 100.0), conservative(0.85), light);
  const glm::dvec3 below(0.3, -0.9539, 0.0);
  const auto view = harris.view({0.0, 0.0, 0.0}, 400.0, below, 48),
             right = calibrated.view({0.0, 0.0, 0.0}, 400.0, below, 48);
  EXPECT_GT(view.light[24 * 48 + 24].x, 0.0);
  EXPECT_LT(view.light[24 * 48 + 24].x, 0.7 * right.light[24 * 48 + 24].x);
}

// Fails if a cloud before the sun has no bright rim: its light where it is thin beside that in its middle.
TEST(ParticleLightTest, EdgesTowardTheSunAreBright) {
  const glm::dvec3 toward_sun = glm::normalize(glm::dvec3(1.0, 0.3, 0.2));
  CloudIllumination light;
  light.suns.push_back({toward_sun, glm::dvec3(100.0)});
  light.sky_kcdpm2 = glm::dvec3(4.0);
  LitCloud cloud(test::heap({.seed = 3, .count = 200, .extinction_per_m = 0.08}), {}, light);
  const test::SpriteView view = cloud.view({0.0, 50.0, 0.0}, 700.0, -toward_sun);
  double edge = 0.0, centre = 0.0;
  int edges = 0, centres = 0;
  for (std::size_t i = 0; i < view.light.size(); ++i) {
    const double x = static_cast<double>(i % 96) - 47.5, y = static_cast<double>(i / 96) - 47.5;
    if (view.opacity[i] > 0.3 && view.opacity[i] < 0.9) edge += view.light[i].x, ++edges;
    if (std::hypot(x, y) < 15.0) centre += view.light[i].x, ++centres;
  }
  ASSERT_GT(edges, 100);
  EXPECT_GT(edge / edges, 1.5 * centre / centres);
}

// Fails if lights do not add up, or a colour takes another's light: two suns and a sky beside each alone.
// Floats and three cycles of multigrid, which is linear, but for the lean: gate 6 %.
TEST(ParticleLightTest, LightsAddUp) {
  CloudIllumination all;
  all.suns.push_back({{0.0, 0.6, 0.8}, glm::dvec3(100.0, 80.0, 60.0)});
  all.suns.push_back({{0.8, 0.6, 0.0}, glm::dvec3(10.0, 20.0, 30.0)});
  all.sky_kcdpm2 = glm::dvec3(2.0, 3.0, 5.0);
  const auto particles = test::heap({.count = 60});
  const glm::dvec3 eye(0.0, 100.0, 3000.0);
  const auto only = [&](std::size_t which) {
    CloudIllumination light;
    if (which < 2) light.suns.push_back(all.suns[which]);
    if (which == 2) light.sky_kcdpm2 = all.sky_kcdpm2;
    return LitCloud(particles, {}, light).sprites(eye);
  };
  const auto together = LitCloud(particles, {}, all).sprites(eye), first = only(0), second = only(1),
             sky = only(2);
  for (std::size_t i = 0; i < together.size(); ++i) {
    // The lean of scattered light is one for all colours and lights: what leans one way takes from the other.
    EXPECT_NEAR(together[i].green, first[i].green + second[i].green + sky[i].green, 0.06f * together[i].green)
        << i;
    EXPECT_NEAR(together[i].optical_depth, first[i].optical_depth, 0.0f);
  }
}

// Fails if a cloud before the sun does not shade those behind it, or shades those beside it: a small ball
// gets what the chord of a large one's middle lets through, e^-t of single scattering without a forward peak,
// and all of it from the side. The tents of the grid spread the large ball: measured 11 % less; gate 15 %.
TEST(ParticleLightTest, CloudsShadeThoseBehindThem) {
  CloudLook isotropic = conservative(0.0);
  isotropic.albedo = glm::dvec3(0.5);
  const CloudLook looks[] = {isotropic, isotropic};
  constexpr float depth = 1.2f, large_m = 300.0f, small_m = 20.0f;
  const auto ball = [](float x, float radius, float through, unsigned cloud) {
    CloudParticle particle{};
    particle.x = x;
    particle.radius = radius;
    particle.red = particle.green = particle.blue = 0.5f;
    particle.cloud = cloud;
    particle.optical_mass = through / 0.998942f * 0.815595f * radius * radius;
    return particle;
  };
  const std::vector<CloudParticle> particles{ball(0.0f, small_m, 0.01f, 0), ball(2000.0f, large_m, depth, 1)};
  const ocl::Device device = ocl::Device::open();
  const ocl::Buffer<CloudParticle> buffer(device, particles, "particles");
  ocl::Buffer<CloudSprite> sprites(device, 2, "sprites");
  ParticleLight lit(device);
  const auto light_of_small = [&](const glm::dvec3& toward_sun) {
    CloudIllumination light;
    light.suns.push_back({toward_sun, glm::dvec3(100.0)});
    lit.relight(buffer, 2, light, looks);
    lit.see({0.0f, 0.0f, 5000.0f}, sprites);
    return sprites.read()[0].green;
  };
  const float beside = light_of_small({0.0, 1.0, 0.0});
  EXPECT_NEAR(light_of_small({-1.0, 0.0, 0.0}) / beside, 1.0f, 0.02f) << "the other stands behind";
  EXPECT_NEAR(light_of_small({1.0, 0.0, 0.0}) / beside / std::exp(-depth), 1.0f, 0.15f);
}

// Fails if work is divided wrongly: the shape of GPUs beside that of CPUs, for two clouds of one call. Sums
// of the same numbers in another order: 1e-4.
TEST(ParticleLightTest, ShapesAgree) {
  std::vector<CloudParticle> particles = test::heap({.count = 40});
  for (CloudParticle particle : test::heap({.seed = 8, .count = 77, .extinction_per_m = 0.1, .cloud = 1})) {
    particle.x += 3000.0f;
    particles.push_back(particle);
  }
  CloudIllumination light;
  light.suns.push_back({{0.0, 0.6, 0.8}, glm::dvec3(100.0, 80.0, 60.0)});
  light.sky_kcdpm2 = glm::dvec3(2.0, 3.0, 5.0);
  std::vector<std::vector<CloudSprite>> found;
  for (const char* shape : {"simd", "workgroup"}) {
    const offing::test::ScopedEnvironment scope("OFFING_SHAPE", shape);
    const ocl::Device device = ocl::Device::open();
    const ocl::Buffer<CloudParticle> buffer(device, particles, "particles");
    ocl::Buffer<CloudSprite> sprites(device, particles.size(), "sprites");
    const CloudLook looks[] = {conservative(0.8), {}};
    ParticleLight lit(device);
    lit.relight(buffer, static_cast<std::uint32_t>(particles.size()), light, looks);
    lit.see({100.0f, 200.0f, 3000.0f}, sprites);
    found.push_back(sprites.read());
  }
  for (std::size_t i = 0; i < particles.size(); ++i)
    EXPECT_NEAR(found[1][i].green, found[0][i].green, 1e-4f * found[0][i].green) << i;
}

// Fails if one particle that is nowhere spoils the others, or if a wrong light is taken.
TEST(ParticleLightTest, BadParticlesStayAloneAndBadLightIsRefused) {
  std::vector<CloudParticle> particles = test::heap({.count = 40});
  particles[3].x = std::nanf("");
  particles[4].optical_mass = std::nanf("");
  CloudIllumination light;
  light.suns.push_back({{0.0, 1.0, 0.0}, glm::dvec3(100.0)});
  LitCloud cloud(particles, {}, light);
  const auto sprites = cloud.sprites({0.0, 0.0, 2000.0});
  for (std::size_t i = 5; i < sprites.size(); ++i)
    EXPECT_TRUE(std::isfinite(sprites[i].red) && sprites[i].red > 0.0f) << i;
  light.suns[0].direction = {0.0, 2.0, 0.0};
  EXPECT_THROW(LitCloud(particles, {}, light), Error);
  light.suns.assign(CLOUD_SUNS + 1, {{0.0, 1.0, 0.0}, glm::dvec3(1.0)});
  EXPECT_THROW(LitCloud(particles, {}, light), Error);
  light.suns.clear();
  light.sky_kcdpm2.x = std::nan("");
  EXPECT_THROW(LitCloud(particles, {}, light), Error);
}

}  // namespace
}  // namespace offing::clouds
