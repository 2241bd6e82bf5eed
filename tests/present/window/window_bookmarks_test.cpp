// Bookmarks of the camera: keys and panel.
#include <string>

#include <gmock/gmock.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/parameter_table.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class WindowBookmarksTest : public WindowTest {
 protected:
  double pitch_rad() const { return state().camera.camera().pitch_rad; }
};

// Fails if keys do not set bookmarks or go to them, an edit of them is not undone, or the camera goes with
// it.
TEST_F(WindowBookmarksTest, Keys) {
  open(quick_options());
  const double at_sky_rad = pitch_rad();
  press_with_control("1");
  ASSERT_EQ(state().scene.bookmarks.size(), 1u) << message();
  look_at_sea();
  const double at_sea_rad = pitch_rad();
  press_with_control("2");
  EXPECT_THAT(message(), HasSubstr("bookmark 2"));
  press("1");
  EXPECT_EQ(pitch_rad(), at_sky_rad);
  press("2");
  EXPECT_EQ(pitch_rad(), at_sea_rad);
  press("3");
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_EQ(pitch_rad(), at_sea_rad);
  press_with_control("z");
  EXPECT_EQ(state().scene.bookmarks.size(), 1u);
  EXPECT_EQ(pitch_rad(), at_sea_rad) << "undo moves no camera";
  press_with_control("z");
  EXPECT_TRUE(state().scene.bookmarks.empty());
}

// Fails if a bookmark does not take the camera off the scene's path.
TEST_F(WindowBookmarksTest, LeaveThePath) {
  present::ViewOptions options = quick_options();
  options.scene = scene::parse_scene(
      "version = 1\n[ocean]\nsize = 32\n[camera]\nx_m = { keys = [{ t = 0, value = 0 }, { t = 100, value = "
      "1000 "
      "}] }\npitch_deg = 70\n[[bookmark]]\nx_m = 7\npitch_deg = 60\n",
      "path.toml", "");
  open(options);
  EXPECT_EQ(state().camera.camera().eye_m.x, 20.0) << "2 s along it";
  press("1");
  turn(2);
  EXPECT_EQ(state().camera.camera().eye_m.x, 7.0);
  press("0");
  turn();
  EXPECT_EQ(state().camera.camera().eye_m.x, 20.0);
}

// Fails if a button or a field of the panel does not do what it says, or what is saved is another view.
TEST_F(WindowBookmarksTest, Panel) {
  open(quick_options());
  const double at_sky_rad = pitch_rad();
  toggle_header("Bookmarks");
  click(find(values(), "add this view##Bookmarks", 40));
  ASSERT_EQ(state().scene.bookmarks.size(), 1u);
  enter(find(values(), present::parameter_label(*scene::find_parameter("bookmark.name")), 60, 0), "bow");
  EXPECT_EQ(state().scene.bookmarks[0].name, "bow");
  look_at_sea();
  const double at_sea_rad = pitch_rad();
  click(find(values(), "go there", 50, 0));
  turn();
  EXPECT_EQ(pitch_rad(), at_sky_rad);
  look_at_sea();
  click(find(values(), "set to this view", 130, 0));
  EXPECT_EQ(state().scene.bookmarks[0].camera.pitch_rad, at_sea_rad);
  EXPECT_EQ(state().scene.bookmarks[0].name, "bow");
  click(find(values(), "place and angles", 60, 0));
  const scene::Parameter& row = *scene::find_parameter("bookmark.pitch_deg");
  const Spot tilt = find(values(), present::parameter_label(row), 70, 0);
  drag(tilt, {tilt.x + 20, tilt.y});
  EXPECT_NE(state().scene.bookmarks[0].camera.pitch_rad, at_sea_rad);

  scene::save_scene(state().scene, "saved.toml", Existing::keep);
  EXPECT_EQ(scene::load_scene("saved.toml").bookmarks[0].name, "bow");

  click(find(values(), "remove", 250, 0));
  EXPECT_TRUE(state().scene.bookmarks.empty());
  press_with_control("z");
  EXPECT_EQ(state().scene.bookmarks.size(), 1u);
}

}  // namespace
}  // namespace offing::test
