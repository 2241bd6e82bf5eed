// The clouds of a world: one array of all particles, lit by its sun and sky, made anew only where they
// change.

#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/cloud_model.h"
#include "host/clouds/genera.h"
#include "host/world/world.h"

namespace offing::world {
namespace {

using clouds::CloudParameters;
using clouds::Genus;

const ocl::Device& device() {
  static const ocl::Device opened = ocl::Device::open();
  return opened;
}

CloudParameters still_cloud(const glm::dvec3& position_m, double radius_m) {
  CloudParameters cloud = clouds::preset(Genus::cumulus);
  cloud.balls = {{glm::dvec3(0.0), radius_m}, {glm::dvec3(radius_m, 0.0, 0.0), 0.5 * radius_m}};
  cloud.levels.resize(1);
  cloud.base_m.reset();
  cloud.position_m = position_m;
  cloud.motion = {};
  return cloud;
}

CloudSkyParameters two_clouds() {
  return {.clouds = {still_cloud({30'000.0, 1500.0, -200.0}, 150.0),
                     still_cloud({30'900.0, 1700.0, 400.0}, 220.0)}};
}

std::vector<CloudParticle> particles_of(const CloudsView& view) {
  std::vector<CloudParticle> particles = view.particles().read();
  particles.resize(view.count());
  return particles;
}

Camera camera_at(const glm::dvec3& eye_m) {
  Camera camera;
  camera.eye_m = eye_m;
  return camera;
}

clouds::CloudIllumination daylight() {
  return {.suns = {{.direction = {0.6, 0.8, 0.0}, .illuminance_klx = glm::dvec3(100.0)}},
          .sky_kcdpm2 = {3.0, 4.0, 6.0},
          .ground_kcdpm2 = glm::dvec3(1.0)};
}

// Fails if a cloud stands at another place of the world, or its particles have another cloud's number.
TEST(CloudsView, HoldsAllCloudsWhereTheyAre) {
  const CloudSkyParameters sky = two_clouds();
  CloudsView view(device(), sky);
  view.at(3.0);
  const std::vector<CloudParticle> all = particles_of(view);
  const glm::dvec3 origin_m = view.sky_origin_m();
  EXPECT_EQ(std::fmod(origin_m.x, 1024.0), 0.0);
  EXPECT_LT(glm::distance(origin_m, sky.clouds[0].position_m), 2000.0);
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (const CloudParticle& due : clouds::particles_at_rest(device(), sky.clouds[i])) {
      const CloudParticle& found = all.at(next++);
      const glm::dvec3 due_m = sky.clouds[i].position_m + glm::dvec3(due.x, due.y, due.z);
      // Floats within 2 km of the origin: half a unit of 2^-13 m; twice for the sum.
      EXPECT_LT(glm::distance(origin_m + glm::dvec3(found.x, found.y, found.z), due_m), 1e-3);
      EXPECT_EQ(found.cloud, i);
      EXPECT_EQ(found.optical_mass, due.optical_mass);
    }
  }
  EXPECT_EQ(next, all.size());
}

// Fails if the order is no permutation, or one that is nearer is blended first.
TEST(CloudsView, OrdersFromFarToNear) {
  CloudsView view(device(), two_clouds());
  view.at(0.0);
  view.light(daylight());
  const glm::dvec3 eye_m(29'000.0, 1200.0, 100.0);
  view.see(camera_at(eye_m));
  const std::vector<CloudParticle> particles = particles_of(view);
  std::vector<std::uint32_t> order = view.order().read();
  order.resize(view.count());
  std::vector<bool> is_seen(view.count(), false);
  double before_m = 1e30;
  for (const std::uint32_t index : order) {
    ASSERT_LT(index, view.count());
    EXPECT_FALSE(is_seen[index]);
    is_seen[index] = true;
    const CloudParticle& particle = particles[index];
    const double distance_m =
        glm::distance(view.sky_origin_m() + glm::dvec3(particle.x, particle.y, particle.z), eye_m);
    EXPECT_LE(distance_m, before_m + 1e-3);
    before_m = distance_m;
  }
}

// Fails if an eye that takes turns with another is shown what that one sees, or what it saw in other light.
TEST(CloudsView, KeepsWhatTwoEyesSee) {
  CloudsView view(device(), two_clouds());
  view.at(0.0);
  const Camera above = camera_at({29'000.0, 1200.0, 100.0}), below = camera_at({29'000.0, -1200.0, 100.0});
  const auto seen_from = [&](const Camera& eye) {
    view.see(eye);
    float light = 0.0f;
    for (const CloudSprite& sprite : view.sprites().read()) light += sprite.green;
    std::vector<std::uint32_t> order = view.order().read();
    order.resize(view.count());
    return std::pair(order, light);
  };
  view.light(daylight());
  const auto from_above = seen_from(above), from_below = seen_from(below);
  EXPECT_NE(from_above.first, from_below.first);
  EXPECT_EQ(seen_from(above), from_above);
  EXPECT_EQ(seen_from(below), from_below);

  clouds::CloudIllumination dusk = daylight();
  dusk.suns.front().illuminance_klx *= 0.5;
  view.light(dusk);
  EXPECT_LT(seen_from(above).second, 0.9f * from_above.second);
  EXPECT_LT(seen_from(below).second, 0.9f * from_below.second);
}

// Fails if light is not finite, or clouds in the sun are dark.
TEST(CloudsView, IsLit) {
  CloudsView view(device(), two_clouds());
  view.at(0.0);
  view.light(daylight());
  view.see(camera_at({30'000.0, 1500.0, 3000.0}));
  std::vector<CloudSprite> sprites = view.sprites().read();
  sprites.resize(view.count());
  float brightest = 0.0f;
  for (const CloudSprite& sprite : sprites) {
    EXPECT_TRUE(std::isfinite(sprite.red) && std::isfinite(sprite.green) && std::isfinite(sprite.blue));
    EXPECT_GE(sprite.optical_depth, 0.0f);
    brightest = std::max(brightest, sprite.green);
  }
  // A white surface under this sun has 100 klx / pi.
  EXPECT_GT(brightest, 3.0f);
}

// Fails if an edit of one cloud changes another, or differs from a view that was made with it.
TEST(CloudsView, AnEditGivesWhatAFreshStartGives) {
  CloudSkyParameters sky = two_clouds();
  CloudsView view(device(), sky);
  view.at(0.0);
  view.light(daylight());
  view.at(8.0);
  EXPECT_FALSE(view.illumination().empty()) << "clouds that stand still are moved";
  sky.clouds[1].balls.push_back({{0.0, 120.0, 0.0}, 90.0});
  view.set(sky);
  view.at(0.0);
  EXPECT_TRUE(view.illumination().empty()) << "other clouds keep the light of those before";
  CloudsView fresh(device(), sky);
  fresh.at(0.0);
  const std::vector<CloudParticle> edited = particles_of(view), made = particles_of(fresh);
  ASSERT_EQ(edited.size(), made.size());
  EXPECT_EQ(std::memcmp(edited.data(), made.data(), made.size() * sizeof(CloudParticle)), 0);
  CloudSkyParameters wrong = sky;
  wrong.clouds[0].balls[0].radius_m = -1.0;
  EXPECT_THROW(view.set(wrong), Error);
  EXPECT_EQ(view.parameters(), sky);
  EXPECT_THROW(view.set({}), Error);
}

// Fails if particles that are given are not those that are shown.
TEST(CloudsView, TakesGivenParticles) {
  CloudSkyParameters sky = two_clouds();
  const CloudParticle one{.x = 5.0f,
                          .y = 0.0f,
                          .z = 0.0f,
                          .radius = 40.0f,
                          .optical_mass = 900.0f,
                          .red = 1.0f,
                          .green = 1.0f,
                          .blue = 1.0f,
                          .texture = 3,
                          .cloud = 0,
                          .id = 17,
                          .turn = 0.5f};
  sky.particles = {std::make_shared<const std::vector<CloudParticle>>(1, one)};
  CloudsView view(device(), sky);
  view.at(0.0);
  const std::vector<CloudParticle> particles = particles_of(view);
  EXPECT_EQ(particles.front().id, 17u);
  EXPECT_EQ(particles.front().texture, 3u);
  EXPECT_EQ(particles.at(1).cloud, 1u);
}

// Fails if clouds of one sky are lit alike: at dusk one above another has more of the sun, and redder the
// lower.
TEST(CloudWorld, LightsEachCloudAtItsAltitude) {
  WorldParameters parameters{.has_sea = false};
  parameters.clouds = two_clouds();
  parameters.clouds->clouds[0].position_m.y = 800.0;
  parameters.clouds->clouds[1].position_m.y = 9000.0;
  World world(device(), parameters);
  world.set_sun({0.9945, 0.1045, 0.0}, 1.0);
  world.at(0.0, 10.0);
  const auto lights = world.clouds()->illumination();
  ASSERT_EQ(lights.size(), 2u);
  const glm::dvec3 low = lights[0].suns.at(0).illuminance_klx, high = lights[1].suns.at(0).illuminance_klx;
  EXPECT_GT(high.y, 1.5 * low.y);
  EXPECT_LT(high.x / high.z, 0.8 * low.x / low.z);
}

// Fails if a world's clouds are not lit by its sun, or stay lit by that of before.
TEST(CloudWorld, FollowsItsSun) {
  WorldParameters parameters{.has_sea = false};
  parameters.clouds = two_clouds();
  World world(device(), parameters);
  ASSERT_NE(world.clouds(), nullptr);
  const auto brightness = [&] {
    world.at(0.0, 10.0);
    world.see_clouds(camera_at({30'000.0, 1500.0, 3000.0}));
    double sum = 0.0;
    for (const CloudSprite& sprite : world.clouds()->sprites().read()) sum += sprite.green;
    return sum;
  };
  const double noon = brightness();
  world.set_sun({0.0, -1.0, 0.0}, 1.0);
  EXPECT_LT(brightness(), 0.01 * noon);
  world.set_clouds({});
  EXPECT_EQ(world.clouds(), nullptr);
  world.at(0.0, 10.0);
}

/// Level ground at sea level, 6.4 km wide.
GroundParameters plain() {
  auto map = std::make_shared<HeightMap>();
  map->columns = map->rows = 65;
  map->spacing_x_m = map->spacing_z_m = 100.0;
  map->heights_m.assign(65 * 65, 0.0f);
  return {.map = map, .origin_x_m = -3200.0, .origin_z_m = -3200.0, .latitude_deg = {}, .lines = {}};
}

/// A ball of this depth over the origin.
CloudSkyParameters ball_sky(double depth, bool throws_shadows) {
  constexpr double radius_m = 100.0;
  CloudParticle ball{};
  ball.radius = static_cast<float>(radius_m);
  ball.optical_mass = static_cast<float>(depth * 0.815595 * radius_m * radius_m);
  ball.red = ball.green = ball.blue = 1.0f;
  return {.clouds = {still_cloud({0.0, 500.0, 0.0}, radius_m)},
          .particles = {std::make_shared<const std::vector<CloudParticle>>(1, ball)},
          .throws_shadows = throws_shadows};
}

// Fails if the ground under a cloud gets more or less of the sun than the cloud lets through: the chord of h
// through its middle is 0.998942 radii (C1), high and low in the sky. Between no shadow and one of depth 60
// the light is that share of the sun's. Texels of 0.8 m; gate 0.01.
TEST(CloudWorld, ShadesTheGroundBelow) {
  WorldParameters parameters{.has_sea = false};
  parameters.ground = plain();
  World world(device(), parameters);
  for (const glm::dvec3& toward_sun : {glm::dvec3(0.6, 0.8, 0.0), glm::dvec3(0.0, 0.28, -0.96)}) {
    world.set_sun({toward_sun.x, toward_sun.y, toward_sun.z}, 1.0);
    Camera camera = camera_at(glm::dvec3(0.0, 500.0, 0.0) - 500.0 / toward_sun.y * toward_sun);
    camera.eye_m.y = 50.0;
    camera.pitch_rad = -1.57;
    camera.vertical_field_of_view_rad = 0.02;
    camera.width_px = camera.height_px = 3;
    const auto light_with = [&](const CloudSkyParameters& clouds) {
      world.set_clouds(clouds);
      world.at(0.0, camera.eye_m.y);
      world.see_ground(camera);
      return double{world.ground()->picture().image.read()[4][1]};
    };
    const double lit = light_with(ball_sky(0.7, false)), shaded = light_with(ball_sky(0.7, true)),
                 dark = light_with(ball_sky(60.0, true));
    ASSERT_GT(lit, 1.2 * dark);
    EXPECT_NEAR((shaded - dark) / (lit - dark), std::exp(-0.7 * 0.998942), 0.01) << toward_sun.y;
  }
}

// Fails if a shadow stays where there is none any more, or is cast again though nothing changed.
TEST(CloudsView, CastsItsShadowWhereSomethingChanged) {
  CloudsView view(device(), two_clouds());
  view.at(0.0);
  view.cast_shadow();
  EXPECT_EQ(view.shadow(), nullptr) << "not lit yet";
  EXPECT_EQ(view.shadow_about({0.0, 0.0, 0.0}).half_width, 0.0f);
  view.light(daylight());
  view.cast_shadow();
  ASSERT_NE(view.shadow(), nullptr);
  const std::uint64_t revision = view.shadow()->revision();
  view.cast_shadow();
  EXPECT_EQ(view.shadow()->revision(), revision);
  clouds::CloudIllumination evening = daylight();
  evening.suns[0].direction = {0.8, 0.6, 0.0};
  view.light(evening);
  EXPECT_EQ(view.shadow(), nullptr) << "of another light";
  view.cast_shadow();
  EXPECT_NE(view.shadow()->revision(), revision);
  EXPECT_NEAR(view.shadow()->params().sun_x, 0.8f, 1e-6f);
  evening.suns.clear();
  view.light(evening);
  view.cast_shadow();
  EXPECT_EQ(view.shadow(), nullptr) << "of no sun";
}

CloudSkyParameters windy_clouds(double light_step_s) {
  CloudSkyParameters sky = two_clouds();
  sky.light_step_s = light_step_s;
  for (CloudParameters& cloud : sky.clouds) cloud.motion.wind_mps = {12.0, 0.0, 5.0};
  return sky;
}

/// What an eye near the first cloud sees, and of its largest light.
struct Seen {
  std::vector<CloudSprite> sprites;
  float brightest = 0.0f;
};

Seen seen_at(const CloudSkyParameters& sky, double time_s) {
  CloudsView view(device(), sky);
  view.at(time_s);
  view.light(daylight());
  view.see(camera_at({30'000.0, 1450.0, 150.0}));
  Seen seen{view.sprites().read()};
  seen.sprites.resize(view.count());
  for (const CloudSprite& sprite : seen.sprites) seen.brightest = std::max(seen.brightest, sprite.green);
  return seen;
}

double largest_difference(const Seen& a, const Seen& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.sprites.size(); ++i)
    largest = std::max(largest, std::abs(double{a.sprites.at(i).green} - b.sprites.at(i).green));
  return largest / a.brightest;
}

// Clouds that only drift look the same from an eye that drifts with them. Fails if the light between two of
// its steps is not seen from where the eye then is: 6 m in 250 m change what particles send to it by
// percents. The gate is what floats within 1 km of their origin leave, 6e-5 m of distances of 100 m, in a
// phase function that changes by a factor of 1e3 over a radian.
TEST(CloudsView, CarriesTheLightOfDriftingClouds) {
  const double time_s = 0.49;
  const Seen exact = seen_at(windy_clouds(0.0), time_s), carried = seen_at(windy_clouds(0.5), time_s);
  ASSERT_EQ(exact.sprites.size(), carried.sprites.size());
  const double difference = largest_difference(exact, carried);
  RecordProperty("difference", std::to_string(difference));
  EXPECT_LT(difference, 1e-3);
  EXPECT_GT(largest_difference(exact, seen_at(windy_clouds(0.0), 0.0)), 1e-2) << "nothing moves";
}

// Fails if light and shadow are worked out between their steps, or a shadow does not go with its clouds.
TEST(CloudsView, WorksOutLightInSteps) {
  CloudsView view(device(), windy_clouds(0.5));
  const auto shadow_at = [&](double time_s) {
    view.at(time_s);
    view.light(daylight());
    view.cast_shadow();
    return std::pair(view.shadow()->revision(), view.shadow_about(view.sky_origin_m()));
  };
  const auto first = shadow_at(2.0), later = shadow_at(2.4), next = shadow_at(2.5), back = shadow_at(2.1);
  EXPECT_EQ(later.first, first.first);
  EXPECT_NEAR(later.second.middle_x - first.second.middle_x, 0.4 * 12.0, 1e-3);
  EXPECT_NEAR(later.second.middle_z - first.second.middle_z, 0.4 * 5.0, 1e-3);
  EXPECT_NE(next.first, first.first);
  EXPECT_NEAR(next.second.middle_x - first.second.middle_x, 0.5 * 12.0, 1e-3);
  EXPECT_NEAR(back.second.middle_x - first.second.middle_x, 0.1 * 12.0, 1e-3)
      << "it depends on what was shown";
}

}  // namespace
}  // namespace offing::world
