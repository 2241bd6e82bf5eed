#include "present/panels/sun_dial.h"

#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"

namespace offing::present {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// Fails if north is not up, east not to the right, or the zenith not in the middle.
TEST(SunDialTest, IsAMapOfTheSky) {
  EXPECT_LE(glm::distance(place_on_dial({0.0, 0.0}), {0.0, -1.0}), 1e-12);
  EXPECT_LE(glm::distance(place_on_dial({90.0 * degree, 0.0}), {1.0, 0.0}), 1e-12);
  EXPECT_LE(glm::distance(place_on_dial({90.0 * degree, 45.0 * degree}), {0.5, 0.0}), 1e-12);
  EXPECT_LE(glm::length(place_on_dial({1.0, 90.0 * degree})), 1e-12);
}

TEST(SunDialTest, LeadsBack) {
  for (const sky::SunAngles sun : {sky::SunAngles{0.3, 0.2}, {6.0, 1.2}, {3.0, -0.2}}) {
    const sky::SunAngles back = sun_of_dial(place_on_dial(sun));
    EXPECT_NEAR(back.azimuth_rad, sun.azimuth_rad, 1e-12);
    EXPECT_NEAR(back.elevation_rad, sun.elevation_rad, 1e-12);
  }
  EXPECT_NEAR(sun_of_dial({0.0, 5.0}).elevation_rad, -18.0 * degree, 1e-12) << "the rim";
}

// Fails if keyframes or a time go on moving a sun that was put somewhere by hand.
TEST(SunDialTest, HandsPutTheSunToRest) {
  scene::Scene scene = scene::parse_scene(
      "version = 1\n[sun]\nelevation_deg = { keys = [{ t = 0, value = 3 }, { t = 9, value = 5 }] }\n",
      "a.toml", "");
  ASSERT_FALSE(scene.tracks.empty());
  place_sun(scene, {1.0, 0.5});
  EXPECT_TRUE(scene.tracks.empty());
  EXPECT_EQ(scene.view.sun_direction.elevation_rad, 0.5);
  EXPECT_EQ(scene.view.sun_direction.azimuth_rad, 1.0);
}

// Fails if an hour is another one's in the saved scene, moves the day, or the dial's place is kept beside it.
TEST(SunDialTest, HoursComeBackFromAFile) {
  scene::Scene scene = scene::parse_scene("version = 1\n[sun]\nelevation_deg = 20\n", "a.toml", "");
  set_hour(scene, 19.5);
  EXPECT_EQ(iso_time(*scene.view.sun_time_utc), "2020-06-21T19:30Z");
  set_hour(scene, 24.0);
  EXPECT_EQ(iso_time(*scene.view.sun_time_utc), "2020-06-21T23:59:59Z");
  const scene::Scene back = scene::parse_scene(scene::scene_text(scene, ""), "b.toml", "");
  EXPECT_EQ(back.view.sun_time_utc, scene.view.sun_time_utc);
  place_sun(scene, {1.0, 0.5});
  EXPECT_FALSE(scene::parse_scene(scene::scene_text(scene, ""), "b.toml", "").view.sun_time_utc);
}

}  // namespace
}  // namespace offing::present
