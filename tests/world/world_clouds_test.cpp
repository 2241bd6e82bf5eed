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
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/shape/genera.h"
#include "host/world/world.h"
#include "tests/world/example_skies.h"

namespace offing::world {
namespace {

using clouds::CloudParameters;

std::vector<CloudParticle> particles_of(const WorldClouds& view) {
  std::vector<CloudParticle> particles = view.particles().read();
  particles.resize(view.count());
  return particles;
}

// Fails if a cloud stands at another place of the world, or its particles have another cloud's number.
TEST(WorldClouds, HoldsAllCloudsWhereTheyAre) {
  const CloudSkyParameters sky = two_clouds();
  WorldClouds view(device(), sky);
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
TEST(WorldClouds, OrdersFromFarToNear) {
  WorldClouds view(device(), two_clouds());
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

// Fails if light is not finite, or clouds in the sun are dark.
TEST(WorldClouds, IsLit) {
  WorldClouds view(device(), two_clouds());
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

// Fails if the sea mirrors clouds in another light than they send it, but for an eye close above it: or in
// the order of another eye.
TEST(WorldClouds, SendsAnEyeCloseAboveTheSeaAndItsMirrorImageOneLight) {
  WorldClouds view(device(), two_clouds());
  view.at(0.0);
  view.light(daylight());
  const auto read = [&] {
    std::vector<std::uint32_t> order = view.order().read();
    order.resize(view.count());
    return std::pair(view.sprites().read(), order);
  };
  const auto seen = [&](double altitude_m) {
    view.see(camera_at({26'000.0, altitude_m, 3000.0}));
    return read();
  };
  const auto mirrored = [&](double altitude_m) {
    view.see_mirrored(camera_at({26'000.0, -altitude_m, 3000.0}), 0.0);
    return read();
  };
  const auto equal = [](const std::vector<CloudSprite>& a, const std::vector<CloudSprite>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(CloudSprite)) == 0;
  };
  // The clouds are more than 3 km away: 10 m are 0.2 degrees, 800 m more than 5.
  const auto [near_light, near_order] = mirrored(5.0);
  EXPECT_TRUE(equal(near_light, seen(5.0).first));
  EXPECT_EQ(near_order, seen(-5.0).second);
  const auto [far_light, far_order] = mirrored(400.0);
  EXPECT_FALSE(equal(far_light, seen(400.0).first));
  EXPECT_TRUE(equal(far_light, seen(-400.0).first));
  EXPECT_EQ(far_order, seen(-400.0).second);
}

// Fails if light that comes in parts never reaches an eye and its mirror image behind a low flight, in which
// they share it; or if parts are left of it where nothing lags any more.
TEST(WorldClouds, LightInPartsArrivesBehindALowFlight) {
  WorldClouds view(device(), two_clouds()), fresh(device(), two_clouds());
  for (WorldClouds* of : {&view, &fresh}) {
    of->at(0.0);
    of->light(daylight());
  }
  constexpr int parts = 4;
  view.set_light_lag({.cloud_rad = 0.01, .cloud_parts = parts});
  const auto look = [](WorldClouds& from, double x_m, double altitude_m) {
    from.see_mirrored(camera_at({x_m, -altitude_m, 3000.0}), 0.0);
    const std::vector<CloudSprite> image = from.sprites().read();
    from.see(camera_at({x_m, altitude_m, 3000.0}));
    return std::pair(image, from.sprites().read());
  };
  const auto equal = [](const std::vector<CloudSprite>& a, const std::vector<CloudSprite>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(CloudSprite)) == 0;
  };
  look(view, 25'000.0, 400.0);
  for (const double x_m : {25'500.0, 26'000.0, 26'500.0}) look(view, x_m, 5.0);
  const auto [due_image, due] = look(fresh, 26'500.0, 400.0);
  // A part may be under way to an eye before: that round ends, then comes one to this eye.
  for (int i = 0; i < 2 * parts; ++i) look(view, 26'500.0, 400.0);
  const auto [image, seen] = look(view, 26'500.0, 400.0);
  EXPECT_TRUE(equal(image, due_image));
  EXPECT_TRUE(equal(seen, due));

  look(view, 24'000.0, 400.0);
  view.set_light_lag({});
  const auto [image_at_once, seen_at_once] = look(view, 24'000.0, 400.0);
  const auto [due_image_there, due_there] = look(fresh, 24'000.0, 400.0);
  EXPECT_TRUE(equal(image_at_once, due_image_there));
  EXPECT_TRUE(equal(seen_at_once, due_there));
}

// Fails if an edit of one cloud changes another, or differs from a view that was made with it.
TEST(WorldClouds, AnEditGivesWhatAFreshStartGives) {
  CloudSkyParameters sky = two_clouds();
  WorldClouds view(device(), sky);
  view.at(0.0);
  view.light(daylight());
  view.at(8.0);
  EXPECT_FALSE(view.illumination().empty()) << "clouds that stand still are moved";
  sky.clouds[1].balls.push_back({{0.0, 120.0, 0.0}, 90.0});
  view.set(sky);
  view.at(0.0);
  EXPECT_TRUE(view.illumination().empty()) << "other clouds keep the light of those before";
  WorldClouds fresh(device(), sky);
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
TEST(WorldClouds, TakesGivenParticles) {
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
  WorldClouds view(device(), sky);
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
  world.set_sun({{0.9945, 0.1045, 0.0}});
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
  world.set_sun({{0.0, -1.0, 0.0}});
  EXPECT_LT(brightness(), 0.01 * noon);
  world.set_clouds({});
  EXPECT_EQ(world.clouds(), nullptr);
  world.at(0.0, 10.0);
}

/// Level ground at sea level, 6.4 km wide.
TerrainParameters plain() {
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
  parameters.terrain = plain();
  World world(device(), parameters);
  for (const glm::dvec3& toward_sun : {glm::dvec3(0.6, 0.8, 0.0), glm::dvec3(0.0, 0.28, -0.96)}) {
    world.set_sun({{toward_sun.x, toward_sun.y, toward_sun.z}});
    Camera camera = camera_at(glm::dvec3(0.0, 500.0, 0.0) - 500.0 / toward_sun.y * toward_sun);
    camera.eye_m.y = 50.0;
    camera.pitch_rad = -1.57;
    camera.vertical_field_of_view_rad = 0.02;
    camera.width_px = camera.height_px = 32;
    const auto light_with = [&](const CloudSkyParameters& clouds) {
      world.set_clouds(clouds);
      world.at(0.0, camera.eye_m.y);
      world.see_terrain(camera);
      // Over pixels that see more and less of the ground's relief.
      double sum = 0.0;
      for (const auto& pixel : world.terrain()->image().image.read()) sum += pixel[1];
      return sum;
    };
    const double lit = light_with(ball_sky(0.7, false)), shaded = light_with(ball_sky(0.7, true)),
                 dark = light_with(ball_sky(60.0, true));
    ASSERT_GT(lit, 1.2 * dark);
    EXPECT_NEAR((shaded - dark) / (lit - dark), std::exp(-0.7 * 0.998942), 0.01) << toward_sun.y;
  }
}

// Fails if a shadow stays where there is none any more, or is cast again though nothing changed.
TEST(WorldClouds, CastsItsShadowWhereSomethingChanged) {
  WorldClouds view(device(), two_clouds());
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

}  // namespace
}  // namespace offing::world
