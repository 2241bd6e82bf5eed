// What eyes see of the clouds of a world, and whose light they share.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/world/example_skies.h"

namespace offing::world {
namespace {

// Fails if an eye that takes turns with its mirror image is shown what that one sees, or what it saw in other
// light.
TEST(WorldClouds, KeepsWhatTwoEyesSee) {
  WorldClouds view(device(), two_clouds());
  view.at(0.0);
  const Camera above = camera_at({29'000.0, 1200.0, 100.0}), below = camera_at({29'000.0, -1200.0, 100.0});
  const auto seen_from = [&](const Camera& eye) {
    eye.eye_m.y > 0.0 ? view.see(eye) : view.see_mirrored(eye, 0.0);
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

CloudSkyParameters windy_clouds(double light_step_s) {
  CloudSkyParameters sky = two_clouds();
  sky.light_step_s = light_step_s;
  for (clouds::CloudParameters& cloud : sky.clouds) cloud.motion.wind_mps = {12.0, 0.0, 5.0};
  return sky;
}

/// What an eye near the first cloud sees, and of its largest light.
struct Seen {
  std::vector<CloudSprite> sprites;
  float brightest = 0.0f;
};

Seen seen_at(const CloudSkyParameters& sky, double time_s) {
  WorldClouds view(device(), sky);
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
TEST(WorldClouds, CarriesTheLightOfDriftingClouds) {
  const double time_s = 0.49;
  const Seen exact = seen_at(windy_clouds(0.0), time_s), carried = seen_at(windy_clouds(0.5), time_s);
  ASSERT_EQ(exact.sprites.size(), carried.sprites.size());
  const double difference = largest_difference(exact, carried);
  RecordProperty("difference", std::to_string(difference));
  EXPECT_LT(difference, 1e-3);
  EXPECT_GT(largest_difference(exact, seen_at(windy_clouds(0.0), 0.0)), 1e-2) << "nothing moves";
}

// Fails if light and shadow are worked out between their steps, or a shadow does not go with its clouds.
TEST(WorldClouds, WorksOutLightInSteps) {
  WorldClouds view(device(), windy_clouds(0.5));
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
  view.set_light_lag({.cloud_steps = 4});
  const auto coarse = shadow_at(2.1);
  EXPECT_EQ(shadow_at(3.9).first, coarse.first);
  EXPECT_NE(shadow_at(4.0).first, coarse.first);
}

// Fails if an eye that is shown light that was sent to another is farther aside than it allows, if that light
// is worked out anew where it need not be, or if it is kept when the sun has moved.
TEST(WorldClouds, SendsAlikeEyesTheSameLight) {
  WorldClouds view(device(), two_clouds());
  view.at(0.0);
  view.light(daylight());
  const auto light_to = [&](const glm::dvec3& eye_m, double tolerance_rad) {
    view.set_light_lag({.cloud_rad = tolerance_rad});
    view.see(camera_at(eye_m));
    view.see_mirrored(camera_at({29'000.0, -1200.0, 100.0}), 0.0);
    view.see(camera_at(eye_m));
    double light = 0.0;
    for (const CloudSprite& sprite : view.sprites().read()) light += sprite.green;
    return light;
  };
  // 300 m and more from the clouds' boxes.
  const glm::dvec3 eye_m(30'000.0, 1000.0, 300.0);
  const double first = light_to(eye_m, 0.01);
  EXPECT_EQ(light_to(eye_m + glm::dvec3(2.0, 0.0, 0.0), 0.01), first);
  EXPECT_NE(light_to(eye_m + glm::dvec3(2.0, 0.0, 0.0), 0.0), first);
  EXPECT_NE(light_to(eye_m + glm::dvec3(40.0, 0.0, 0.0), 0.01), first);
  const double there = light_to(eye_m, 0.01);
  clouds::CloudIllumination evening = daylight();
  evening.suns[0].direction = {0.8, 0.6, 0.0};
  view.light(evening);
  EXPECT_NE(light_to(eye_m, 0.01), there);
}

// Fails if an eye's light that comes in parts is not all there after them, or if all of it is worked out at
// once, or if the light of another sun comes in parts.
TEST(WorldClouds, SendsLightInParts) {
  const glm::dvec3 first_m(30'000.0, 1000.0, 300.0), then_m(29'000.0, 1500.0, 300.0);
  const auto light_of = [](WorldClouds& view, const glm::dvec3& eye_m) {
    view.see(camera_at(eye_m));
    std::vector<float> light;
    for (const CloudSprite& sprite : view.sprites().read()) light.push_back(sprite.green);
    light.resize(view.count());
    return light;
  };
  const auto viewed = [&] {
    WorldClouds view(device(), two_clouds());
    view.at(0.0);
    view.light(daylight());
    return view;
  };
  WorldClouds exact = viewed(), view = viewed();
  view.set_light_lag({.cloud_rad = 1e-9, .cloud_parts = 3});
  const auto from_first = light_of(exact, first_m), from_then = light_of(exact, then_m);
  EXPECT_EQ(light_of(view, first_m), from_first);
  view.see_mirrored(camera_at({29'000.0, -9000.0, 300.0}), 0.0);
  for (std::size_t part = 1; part <= 3; ++part) {
    // The third of the two clouds' particles, rounded down, is new.
    const auto bound = static_cast<std::ptrdiff_t>(from_first.size() * part / 3);
    std::vector<float> expected = from_first;
    std::copy(from_then.begin(), from_then.begin() + bound, expected.begin());
    EXPECT_EQ(light_of(view, then_m), expected) << part;
  }
  EXPECT_EQ(light_of(view, then_m), from_then);
  clouds::CloudIllumination evening = daylight();
  evening.suns[0].direction = {0.8, 0.6, 0.0};
  exact.light(evening);
  view.light(evening);
  EXPECT_EQ(light_of(view, then_m), light_of(exact, then_m));
}

// Fails if light that is worked out over frames is seen before it is whole, if it is not that of its time, or
// if a sun that moves meanwhile is forgotten.
TEST(WorldClouds, WorksOutLightOverFrames) {
  WorldClouds exact(device(), windy_clouds(0.5)), view(device(), windy_clouds(0.5));
  const auto seen_at = [](WorldClouds& of, double time_s, const clouds::CloudIllumination& light) {
    of.at(time_s);
    of.light(light);
    // An eye that goes with the clouds.
    of.see(camera_at(glm::dvec3(30'000.0, 1450.0, 150.0) + time_s * glm::dvec3(12.0, 0.0, 5.0)));
    std::vector<float> seen;
    for (const CloudSprite& sprite : of.sprites().read()) seen.push_back(sprite.green);
    seen.resize(of.count());
    return seen;
  };
  view.set_light_lag({.cloud_light_frames = 3});
  clouds::CloudIllumination evening = daylight();
  evening.suns[0].direction = {0.8, 0.6, 0.0};
  const auto by_day = seen_at(exact, 2.0, daylight()), later = seen_at(exact, 2.5, daylight()),
             at_night_fall = seen_at(exact, 2.5, evening);
  ASSERT_NE(by_day, at_night_fall);
  EXPECT_EQ(seen_at(view, 2.0, daylight()), by_day) << "the first light comes at once";
  for (int frame = 1; frame <= 2; ++frame) {
    const auto seen = seen_at(view, 2.5, daylight());
    double difference = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i)
      difference = std::max(difference, std::abs(double{seen[i]} - by_day[i]) / by_day[i]);
    // The same but for floats: places and the eye are 6 m on.
    EXPECT_LT(difference, 1e-2) << frame;
    EXPECT_EQ(view.illumination()[0].suns[0].direction, daylight().suns[0].direction);
  }
  EXPECT_EQ(seen_at(view, 2.5, evening), later) << "the frame in which it is whole";
  for (int frame = 1; frame <= 3; ++frame) {
    EXPECT_EQ(view.illumination()[0].suns[0].direction, daylight().suns[0].direction) << frame;
    seen_at(view, 2.5, evening);
  }
  EXPECT_EQ(seen_at(view, 2.5, evening), at_night_fall);
}

// Fails if clouds that lag and only moved are lit in bursts, or if another light on them has to wait for
// that.
TEST(WorldClouds, LightsMovedCloudsPartByPart) {
  WorldClouds view(device(), windy_clouds(0.5));
  view.set_light_lag({.cloud_steps = 4, .cloud_light_frames = 3});
  clouds::CloudIllumination evening = daylight();
  evening.suns[0].direction = {0.8, 0.6, 0.0};
  const auto lit = [&](double time_s, const clouds::CloudIllumination& light) {
    view.at(time_s);
    view.light(light);
    return view.illumination()[0].suns[0].direction;
  };
  const auto frames_of_shadow = [&](double time_s) {
    view.cast_shadow();
    int frames = 0;
    while (view.shadow() != nullptr && frames < 100) lit(time_s, daylight()), ++frames;
    return frames;
  };
  lit(2.0, daylight());
  const int frames = frames_of_shadow(4.0);
  EXPECT_GT(frames, 8);
  EXPECT_LT(frames, 100);
  for (int frame = 1; frame <= 5; ++frame) EXPECT_EQ(lit(6.0, daylight()), daylight().suns[0].direction);
  for (int frame = 1; frame <= 2; ++frame) EXPECT_EQ(lit(6.0, evening), daylight().suns[0].direction);
  EXPECT_EQ(lit(6.0, evening), evening.suns[0].direction);
}

// Fails if clouds jump in the frame in which their light is whole, or if what interrupts it leaves light of
// before.
TEST(WorldClouds, CarriesCloudsWhileTheirLightIsWorkedOut) {
  CloudSkyParameters sky = windy_clouds(0.5);
  WorldClouds view(device(), sky), exact(device(), sky);
  view.set_light_lag({.cloud_steps = 4, .cloud_light_frames = 3});
  const auto first_place = [](WorldClouds& of, double time_s) {
    of.at(time_s);
    of.light(daylight());
    const glm::dvec3 origin_m = of.sky_origin_m();
    const CloudParticle first = of.particles().read().front();
    return origin_m + glm::dvec3(first.x, first.y, first.z);
  };
  const glm::dvec3 start_m = first_place(view, 2.0);
  for (int frame = 1; frame <= 30; ++frame) {
    const double elapsed_s = 0.1 * frame;
    EXPECT_LT(
        glm::distance(first_place(view, 2.0 + elapsed_s), start_m + elapsed_s * glm::dvec3(12.0, 0.0, 5.0)),
        1e-3)
        << elapsed_s;
  }
  EXPECT_EQ(view.lit_at_s(), 4.0);
  // Interrupted while light is under way: at 6 s it begins anew.
  first_place(view, 6.0);
  view.set_particle_halvings(1);
  exact.set_particle_halvings(1);
  exact.set_light_lag({.cloud_steps = 4});
  EXPECT_EQ(first_place(view, 6.0), first_place(exact, 6.0));
  EXPECT_EQ(view.lit_at_s(), 6.0);
  EXPECT_THROW(view.light(std::vector<clouds::CloudIllumination>(3, daylight())), Error);
}

// Clouds that lag keep their shape between steps of light and go on with the wind. Fails if they stand still,
// if they change, or if they are seen from elsewhere than the eye.
TEST(WorldClouds, CarriesClouds) {
  CloudSkyParameters sky = windy_clouds(0.5);
  for (clouds::CloudParameters& cloud : sky.clouds) cloud.motion.sway_m = 20.0;
  sky.clouds[0].turbulence.change_per_s = sky.clouds[1].turbulence.change_per_s = 0.2;
  WorldClouds view(device(), sky), exact(device(), sky);
  view.set_light_lag({.cloud_steps = 4});
  const auto places_at = [](WorldClouds& of, double time_s) {
    of.at(time_s);
    of.light(daylight());
    of.see(camera_at({30'000.0, 1450.0, 150.0}));
    std::vector<glm::dvec3> places;
    const std::vector<CloudParticle> particles = of.particles().read();
    for (std::size_t i = 0; i < of.count(); ++i)
      places.push_back(of.sky_origin_m() + glm::dvec3(particles[i].x, particles[i].y, particles[i].z));
    return places;
  };
  const auto at_step = places_at(view, 2.0), later = places_at(view, 3.5), own = places_at(exact, 3.5);
  EXPECT_EQ(at_step, places_at(exact, 2.0));
  double sway_m = 0.0;
  for (std::size_t i = 0; i < at_step.size(); ++i) {
    // Floats within 1 km.
    EXPECT_LT(glm::distance(later[i], at_step[i] + 1.5 * glm::dvec3(12.0, 0.0, 5.0)), 1e-3);
    sway_m = std::max(sway_m, glm::distance(later[i], own[i]));
  }
  EXPECT_GT(sway_m, 1.0) << "nothing sways";
  const std::vector<std::uint32_t> order = view.order().read();
  const glm::dvec3 eye_m(30'000.0, 1450.0, 150.0);
  for (std::size_t i = 1; i < later.size(); ++i) {
    EXPECT_GE(glm::distance(later[order[i - 1]], eye_m), glm::distance(later[order[i]], eye_m) - 0.1);
  }
  view.set_light_lag({});
  EXPECT_EQ(places_at(view, 3.5), own);
}

}  // namespace
}  // namespace offing::world
