// What the cloud editor does to a scene, without a window.
#include "present/editing/cloud_edits.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/schema/parameter_table.h"
#include "present/editing/cloud_picker.h"

namespace offing::present {
namespace {

using scene::Scene;

Scene scene_of(const std::string& text) {
  return scene::parse_scene("version = 1\n" + text, "a.toml", "");
}

Scene two_clouds() {
  return scene_of(R"([[cloud]]
name = "path"
scale = 2
x_m = { keys = [{ t = 0, value = 10 }, { t = 20, value = 30 }] }
[[cloud.ball]]
x_m = -10
radius_m = 80
[[cloud.ball]]
y_m = 20
radius_m = 50
[[cloud]]
genus = "cumulus"
y_m = 1200
)");
}

clouds::CloudParameters of(const Scene& scene, std::size_t cloud) {
  return scene::cloud_parameters_of(scene, cloud);
}

// Balls of a genus become the cloud's own before they are changed. Fails if that changes the cloud by
// itself: its base, scale or balls.
TEST(CloudEditsTest, OwnBallsAreThoseOfTheGenus) {
  Scene scene = two_clouds();
  scene.clouds[1].scale = 4.0;  // dividing by it loses no digit
  const clouds::CloudParameters before = of(scene, 1);
  EXPECT_EQ(own_balls(scene, 1).size(), before.balls.size());
  EXPECT_EQ(of(scene, 1), before);
}

// Fails if what has no room for all of it has been done in part.
TEST(CloudEditsTest, CopiesAllOrNothing) {
  Scene scene = two_clouds();
  scene.clouds[1].balls.resize(scene::find_parameter("cloud.ball.radius_m")->max_count);
  const std::size_t before = scene.clouds[0].balls.size();
  EXPECT_THROW(duplicate_parts(scene, {{0, 0}, {1, 0}}, {}), Error);
  EXPECT_EQ(scene.clouds[0].balls.size(), before);
  EXPECT_THROW(add_ball(scene, 1, clouds::Genus::cumulus, {{}, 50.0}, 0.0), Error);
  while (scene.clouds.size() < scene::find_parameter("cloud.name")->max_count) scene.clouds.emplace_back();
  EXPECT_THROW(duplicate_parts(scene, {{0, 0}, {0, {}}}, {}), Error);
  EXPECT_EQ(scene.clouds[0].balls.size(), before);
}

// Fails if the balls of a genus are more than a scene file may have, so that what the editor saves cannot be
// read.
TEST(CloudEditsTest, OwnBallsOfEachGenusCanBeSaved) {
  for (const char* genus : {"cirrus", "stratus", "cumulus", "stratocumulus", "altocumulus", "cumulonimbus",
                            "lenticular", "funnel"}) {
    Scene scene = scene_of(std::string("[[cloud]]\ngenus = \"") + genus + "\"\n");
    const std::size_t count = own_balls(scene, 0).size();
    const Scene again = scene::parse_scene(scene::scene_text(scene, ""), "again.toml", "");
    EXPECT_EQ(again.clouds[0].balls.size(), count) << genus;
  }
}

// Fails if balls that a shape has taken the place of can be picked, or added to.
TEST(CloudEditsTest, ShapesHaveNoBalls) {
  Scene scene = scene_of("[[cloud]]\nshape = \"bird\"\n");
  EXPECT_TRUE(balls_of(scene, 0, 0.0).empty());
  EXPECT_FALSE(has_part(scene, {0, 0}));
  EXPECT_TRUE(has_part(scene, {0, {}}));
  EXPECT_THROW(add_ball(scene, 0, clouds::Genus::cumulus, {{}, 50.0}, 0.0), Error);
  EXPECT_TRUE(scene.clouds[0].balls.empty());
}

// Fails if a part does not go as far as the hand, in a cloud with a scale too, or takes others along.
TEST(CloudEditsTest, PartsGoWhereTheyArePulled) {
  Scene scene = two_clouds();
  const std::vector<Sphere> before = balls_of(scene, 0, 5.0);
  const glm::dvec3 way_m(6.0, -8.0, 24.0);
  move_part(scene, {0, 1}, way_m);
  const std::vector<Sphere> after = balls_of(scene, 0, 5.0);
  EXPECT_LE(glm::distance(after[1].centre_m, before[1].centre_m + way_m), 1e-9);
  EXPECT_EQ(after[0].centre_m, before[0].centre_m);
  // The whole of it with its keyframes, at every time.
  for (const double time_s : {0.0, 15.0}) {
    Scene moved = scene;
    move_part(moved, {0, {}}, way_m);
    EXPECT_LE(glm::distance(origin_of_cloud(moved, 0, time_s), origin_of_cloud(scene, 0, time_s) + way_m),
              1e-9);
  }
  const glm::dvec3 usual_m = origin_of_cloud(scene, 1, 0.0);
  move_part(scene, {1, {}}, way_m);
  EXPECT_LE(glm::distance(origin_of_cloud(scene, 1, 0.0), usual_m + way_m), 1e-9);
}

// A cloud without y_m stands at its genus' altitude: pulled sideways it stays there, by itself.
TEST(CloudEditsTest, AltitudesOfAGenusStay) {
  Scene scene = scene_of("[[cloud]]\ngenus = \"cirrus\"\n");
  const double altitude_m = origin_of_cloud(scene, 0, 0.0).y;
  move_part(scene, {0, {}}, {100.0, 0.0, 0.0});
  EXPECT_FALSE(scene.clouds[0].altitude_m);
  move_part(scene, {0, {}}, {0.0, 50.0, 0.0});
  EXPECT_EQ(origin_of_cloud(scene, 0, 0.0), glm::dvec3(100.0, altitude_m + 50.0, 0.0));
}

TEST(CloudEditsTest, PartsGrow) {
  Scene scene = two_clouds();
  resize_part(scene, {0, 0}, 1.5);
  EXPECT_EQ(balls_of(scene, 0, 0.0)[0].radius_m, 240.0);
  resize_part(scene, {0, {}}, 0.5);
  EXPECT_EQ(balls_of(scene, 0, 0.0)[0].radius_m, 120.0);
  resize_part(scene, {0, 0}, 1e12);
  EXPECT_EQ(scene.clouds[0].balls[0].radius_m, 1e6) << "the range of the table";
}

// Fails if numbers of those behind are off by what went before them, or keyframes go to another cloud.
TEST(CloudEditsTest, PartsAreTakenAway) {
  Scene scene = two_clouds();
  remove_parts(scene, {{0, 0}, {1, {}}});
  ASSERT_EQ(scene.clouds.size(), 1u);
  ASSERT_EQ(scene.clouds[0].balls.size(), 1u);
  EXPECT_EQ(scene.clouds[0].balls[0].radius_m, 50.0);
  EXPECT_EQ(scene.tracks.size(), 1u);
  // Not the balls of its genus.
  remove_parts(scene, {{0, 0}});
  EXPECT_TRUE(scene.clouds.empty());
  EXPECT_TRUE(scene.tracks.empty());

  scene = two_clouds();
  remove_parts(scene, {{0, 0}, {0, 1}, {0, {}}});
  ASSERT_EQ(scene.clouds.size(), 1u);
  EXPECT_EQ(scene.clouds[0].altitude_m, 1200.0);
}

TEST(CloudEditsTest, PartsAreDuplicated) {
  Scene scene = two_clouds();
  const std::vector<CloudPart> copies = duplicate_parts(scene, {{0, 1}, {0, {}}}, {40.0, 0.0, 0.0});
  ASSERT_THAT(copies, testing::ElementsAre(CloudPart{0, 2}, CloudPart{2, {}}));
  const std::vector<Sphere> balls = balls_of(scene, 0, 0.0);
  EXPECT_LE(glm::distance(balls[2].centre_m, balls[1].centre_m + glm::dvec3(40.0, 0.0, 0.0)), 1e-9);
  EXPECT_EQ(balls[2].radius_m, balls[1].radius_m);
  // With its path, beside it.
  EXPECT_EQ(origin_of_cloud(scene, 2, 20.0).x, 70.0);
  EXPECT_EQ(origin_of_cloud(scene, 0, 20.0).x, 30.0);
}

// Fails if a ball is not where it was placed, or a first one makes a cloud with a genus' balls beside it.
TEST(CloudEditsTest, BallsArePlaced) {
  Scene scene = two_clouds();
  const Sphere wanted{{500.0, 1300.0, -70.0}, 90.0};
  const CloudPart beside = add_ball(scene, 0, clouds::Genus::cirrus, wanted, 12.0);
  EXPECT_EQ(beside, (CloudPart{0, 2}));
  const Sphere found = balls_of(scene, 0, 12.0)[2];
  EXPECT_LE(glm::distance(found.centre_m, wanted.centre_m), 1e-9);
  EXPECT_NEAR(found.radius_m, 90.0, 1e-9);
  const CloudPart alone = add_ball(scene, {}, clouds::Genus::stratus, wanted, 0.0);
  EXPECT_EQ(alone, (CloudPart{2, 0}));
  EXPECT_EQ(scene.clouds[2].genus, clouds::Genus::stratus);
  ASSERT_EQ(balls_of(scene, 2, 0.0).size(), 1u);
  EXPECT_EQ(balls_of(scene, 2, 0.0)[0].centre_m, wanted.centre_m);
  scene.clouds[2].shape.text = "K";
  EXPECT_THROW(add_ball(scene, 2, clouds::Genus::stratus, wanted, 0.0), Error);
}

// Fails if the sea that a scene has without a word goes with its first cloud, or one comes to ground.
TEST(CloudEditsTest, TheSeaStays) {
  Scene sea = scene_of(""), sky = two_clouds();
  add_cloud(sea, clouds::Genus::cumulus, {0.0, 1000.0, 0.0});
  EXPECT_TRUE(sea.has_sea());
  add_cloud(sky, clouds::Genus::cumulus, {0.0, 1000.0, 0.0});
  EXPECT_FALSE(sky.has_sea());
}

// Fails if a genus leaves something of the last one's, or takes away what was made by hand.
TEST(CloudEditsTest, GeneraAreApplied) {
  Scene scene = scene_of(
      "[[cloud]]\nname = \"mine\"\nx_m = 5\nseed = 9\nnoise_blend = 0.9\nextinction_per_m = 0.5\nmodelling = "
      "\"hierarchical\"\n[[cloud]]\nname = \"mine\"\ngenus = \"stratus\"\nx_m = 5\nseed = 9\n");
  apply_genus(scene, 0, clouds::Genus::stratus);
  EXPECT_EQ(of(scene, 0), of(scene, 1));
  scene.clouds[0].balls = {{.centre_m = {1.0, 2.0, 3.0}, .radius_m = 40.0}};
  apply_genus(scene, 0, clouds::Genus::cumulus);
  EXPECT_EQ(scene.clouds[0].balls.size(), 1u);
  EXPECT_EQ(scene.clouds[0].name, "mine");
}

// What the editor makes is what a scene file gives back. Fails if a place or a radius loses digits there.
TEST(CloudEditsTest, ComeBackFromAFile) {
  Scene scene = two_clouds();
  move_part(scene, {1, 3}, {1.0 / 3.0, 0.1, -7.7});
  resize_part(scene, {1, 2}, 1.1);
  add_ball(scene, {}, clouds::Genus::stratus, {{0.1, 900.0 / 7.0, 3.0}, 77.7}, 0.0);
  scene.clouds[1].edits = {
      {.selection = {.eye_m = {1.0 / 3.0, 2.0, 3.0}, .low = {-0.1, -0.2}, .high = {0.3, 0.4}},
       .push_m = {1.0 / 7.0, 0.0, 0.0}}};
  const Scene back = scene::parse_scene(scene::scene_text(scene, ""), "b.toml", "");
  ASSERT_EQ(back.clouds.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(of(back, i), of(scene, i)) << i;
}

Screen screen() {
  Screen screen{.camera = {}, .size_px = {600.0, 600.0}};
  screen.camera.eye_m = {0.0, 500.0, 2000.0};
  screen.camera.width_px = screen.camera.height_px = 600;
  return screen;
}

glm::dvec2 clip_of(const glm::dvec3& place_m) {
  const glm::dvec2 px = *pixel_of(screen(), place_m);
  return {2.0 * px.x / 600.0 - 1.0, 1.0 - 2.0 * px.y / 600.0};
}

// Fails if the ball under the mouse is not picked, or one behind it can never be.
TEST(CloudPickerTest, ClicksReachEveryBall) {
  const Scene scene = scene_of(
      "[[cloud]]\ny_m = 500\n[[cloud.ball]]\nradius_m = 100\n[[cloud.ball]]\nz_m = -300\nradius_m = "
      "150\n[[cloud.ball]]\nx_m = 400\nradius_m = 50\n");
  const ShownClouds shown{scene, nullptr, 0.0};
  const Ray ray = ray_at(screen(), clip_of({0.0, 500.0, 0.0}));
  const std::optional<CloudPart> first = pick_ball(shown, ray, {});
  ASSERT_TRUE(first);
  const std::optional<CloudPart> second = pick_ball(shown, ray, first);
  EXPECT_NE(first, second);
  EXPECT_EQ(pick_ball(shown, ray, second), first);
  EXPECT_EQ(pick_ball(shown, ray_at(screen(), clip_of({400.0, 500.0, 0.0})), first), (CloudPart{0, 2}));
  EXPECT_FALSE(pick_ball(shown, ray_at(screen(), {-0.9, 0.9}), first));
  const ClipBox right = box_between(clip_of({200.0, 300.0, 0.0}), clip_of({600.0, 700.0, 0.0}));
  EXPECT_THAT(parts_in(shown, screen(), right, PartKind::balls), testing::ElementsAre(CloudPart{0, 2}));
}

}  // namespace
}  // namespace offing::present
