// Clouds of a world in fewer of their particles, and back in all of them.

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/particles/particle_thinning.h"
#include "host/world/world.h"
#include "tests/world/example_skies.h"

namespace offing::world {
namespace {

/// All that a view has of its clouds, but for places that mean nothing.
struct Shown {
  std::vector<CloudParticle> particles;
  std::vector<CloudSprite> sprites;
  std::vector<std::uint32_t> order;
  std::vector<clouds::CloudShadowMap::Texel> shadow;
};

Shown shown_at(WorldClouds& view, double time_s) {
  view.at(time_s);
  view.light(daylight());
  view.cast_shadow();
  view.see(camera_at({30'000.0, 1450.0, 150.0}));
  Shown shown{view.particles().read(), view.sprites().read(), view.order().read(),
              view.shadow()->map().read()};
  shown.particles.resize(view.count());
  shown.sprites.resize(view.count());
  shown.order.resize(view.count());
  return shown;
}

template <class Value>
void expect_same(const std::vector<Value>& a, const std::vector<Value>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)), 0) << what;
}

void expect_same(const Shown& a, const Shown& b) {
  expect_same(a.particles, b.particles, "particles");
  expect_same(a.sprites, b.sprites, "sprites");
  expect_same(a.order, b.order, "order");
  expect_same(a.shadow, b.shadow, "shadow");
}

CloudSkyParameters drifting_clouds() {
  CloudSkyParameters sky = two_clouds();
  for (clouds::CloudParameters& cloud : sky.clouds) {
    cloud.motion.wind_mps = {12.0, 0.0, 5.0};
    cloud.motion.sway_m = 10.0;
  }
  return sky;
}

/// Of clouds with this lag, asked for one number of halvings after another.
void expect_nothing_of_before(const LightLag& lag) {
  const CloudSkyParameters sky = drifting_clouds();
  const auto opened = [&] {
    WorldClouds view(device(), sky);
    view.set_light_lag(lag);
    return view;
  };
  WorldClouds view = opened();
  const Shown whole = shown_at(view, 3.2);
  EXPECT_EQ(view.whole_count(), view.count());
  for (const int halvings : {1, 2, 1, 0, 2, 0}) {
    view.set_particle_halvings(halvings);
    WorldClouds fresh = opened();
    fresh.set_particle_halvings(halvings);
    const Shown due = shown_at(fresh, 3.2);
    expect_same(shown_at(view, 3.2), due);
    std::vector<std::uint32_t> places = due.order;
    std::ranges::sort(places);
    for (std::uint32_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i], i);
    if (halvings == 0) expect_same(due, whole);
    const double share = static_cast<double>(view.count()) / view.whole_count();
    EXPECT_NEAR(share, halvings == 0 ? 1.0 : (halvings == 1 ? 0.53 : 0.3), 0.05);
  }
}

// Fails if particles, light, order or shadow of clouds depend on what was shown before, in all of their
// particles or in fewer, of clouds that lag behind too.
TEST(WorldClouds, ShowsFewerParticlesAndAllAgain) {
  expect_nothing_of_before({});
  expect_nothing_of_before({.cloud_steps = 4, .cloud_rad = 0.01, .cloud_parts = 8});
}

// Fails if halved clouds that move are not the halves of those at rest moved, each under its number.
TEST(WorldClouds, MovesItsHalves) {
  const CloudSkyParameters sky = drifting_clouds();
  WorldClouds view(device(), sky);
  view.set_particle_halvings(1);
  const Shown shown = shown_at(view, 2.0);
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < 2; ++i) {
    const auto rest = clouds::thinned_particles(clouds::particles_at_rest(device(), sky.clouds[i]), 1);
    clouds::CloudModel model(device(), sky.clouds[i], rest, i);
    model.at(2.0, view.sky_origin_m());
    for (const CloudParticle& due : model.particles().read()) {
      EXPECT_EQ(std::memcmp(&shown.particles.at(next++), &due, sizeof(due)), 0);
    }
  }
  EXPECT_EQ(next, shown.particles.size());
}

// Fails if an edit of halved clouds gives others than a fresh start, or one that cannot be made changes them.
TEST(WorldClouds, EditsHalvedClouds) {
  CloudSkyParameters sky = drifting_clouds();
  WorldClouds view(device(), sky);
  view.set_particle_halvings(2);
  shown_at(view, 1.0);
  sky.clouds[1].balls.push_back({{0.0, 120.0, 0.0}, 90.0});
  view.set(sky);
  WorldClouds fresh(device(), sky);
  fresh.set_particle_halvings(2);
  const Shown due = shown_at(fresh, 1.0);
  expect_same(shown_at(view, 1.0), due);
  EXPECT_THROW(view.set_particle_halvings(clouds::most_particle_halvings + 1), Error);
  EXPECT_THROW(view.set_particle_halvings(-1), Error);
  expect_same(shown_at(view, 1.0), due);
}

// Fails if clouds that come later have all of their particles, or if a world loses track of what is asked.
TEST(CloudWorld, HalvesCloudsThatComeLater) {
  World world(device(), {.has_sea = false});
  world.set_cloud_halvings(1);
  world.set_clouds(two_clouds());
  EXPECT_LT(world.clouds()->count(), 0.6 * world.clouds()->whole_count());
  world.set_cloud_halvings(0);
  EXPECT_EQ(world.clouds()->count(), world.clouds()->whole_count());
}

}  // namespace
}  // namespace offing::world
