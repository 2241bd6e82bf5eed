#include "present/window/bookmarks.h"

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"

namespace offing::present {
namespace {

Camera camera_at(double x_m) {
  return {.eye_m = {x_m, 2.0, 3.0}, .yaw_rad = 0.5, .pitch_rad = -0.25, .width_px = 100, .height_px = 50};
}

// Fails if a bookmark beyond the last one leaves a gap, one that is there loses its name, or a view is not
// what comes back.
TEST(BookmarksTest, AreSetAndGoneTo) {
  scene::Scene scene;
  EXPECT_EQ(set_bookmark(scene, camera_at(1.0), 7), "bookmark 1, view 1 is this view");
  EXPECT_EQ(set_bookmark(scene, camera_at(2.0), 2), "bookmark 2, view 2 is this view");
  scene.bookmarks[0].name = "bow";
  EXPECT_EQ(set_bookmark(scene, camera_at(5.0), 1), "bookmark 1, bow is this view now");
  ASSERT_EQ(scene.bookmarks.size(), 2u);
  Camera camera = camera_at(9.0);
  camera.width_px = 640;
  EXPECT_EQ(go_to_bookmark(scene, 1, camera), "bookmark 1, bow");
  EXPECT_EQ(camera.eye_m.x, 5.0);
  EXPECT_EQ(camera.pitch_rad, -0.25);
  EXPECT_EQ(camera.width_px, 640) << "the picture stays as large as it is";
}

// Fails if a bookmark that is not there moves the camera, or a scene gets more than a file may have.
TEST(BookmarksTest, OnesThatCannotBeAreRefused) {
  scene::Scene scene;
  Camera camera = camera_at(9.0);
  for (const std::size_t number : {0u, 1u}) EXPECT_THROW(go_to_bookmark(scene, number, camera), Error);
  EXPECT_EQ(camera.eye_m.x, 9.0);
  for (int i = 0; i < 64; ++i) set_bookmark(scene, camera, 65);
  EXPECT_THROW(set_bookmark(scene, camera, 65), Error);
  EXPECT_EQ(scene.bookmarks.size(), 64u);
}

}  // namespace
}  // namespace offing::present
