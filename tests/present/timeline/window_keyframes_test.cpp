// Keyframes on the timeline.
#include <fstream>
#include <string>
#include <vector>

#include "host/scene/file/scene_file.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

class WindowKeyframesTest : public WindowTest {
 protected:
  /// The camera flies and the sun moves.
  static constexpr const char* moving =
      "version = 1\n[time]\nend_s = 8\n[ocean]\nsize = 32\n[camera]\npitch_deg = -15\n"
      "x_m = { keys = [{ t = 0, value = 0 }, { t = 4, value = 100 }, { t = 8, value = 0 }] }\n[sun]\n"
      "elevation_deg = { keys = [{ t = 0, value = 10 }, { t = 4, value = 60 }] }\n";

  present::ViewOptions options_of(const std::string& text) const {
    std::ofstream(folder_.path() / "moving.toml") << text;
    present::ViewOptions options = quick_options();
    options.scene_file = folder_.path() / "moving.toml";
    options.scene_name = "moving";
    options.scene = scene::load_scene(options.scene_file);
    return options;
  }
  std::vector<double> times(const char* key) const {
    std::vector<double> found;
    for (const Keyframe& each : state().scene.tracks.at({key}).keys) found.push_back(each.time_s);
    return found;
  }
  /// Keyframes lie at the bottom of the timeline.
  Spot on_keys(double time_s) const {
    const Spot middle = on_timeline(time_s);
    return {middle.x, middle.y + 9};
  }
  void drag_keys(double from_s, double to_s) {
    const Spot from = on_keys(from_s), to = on_keys(to_s);
    pull({from.x, from.y}, {to.x, to.y});
  }
};

// Fails if keyframes are not where the mouse drops them, those of one time part, undo and redo do not bring
// back the picture, or what is saved is another picture than the one shown.
TEST_F(WindowKeyframesTest, AreDraggedUndoneAndSaved) {
  open(options_of(moving));
  const std::vector<unsigned char> before = picture();
  drag_keys(4.0, 2.5);
  const double moved_s = times("camera.x_m")[1];
  EXPECT_NEAR(moved_s, 2.5, 0.06);
  EXPECT_EQ(times("sun.elevation_deg")[1], moved_s);
  EXPECT_EQ(state().clock.time_s(), 2.0) << "keyframes are dragged, not the time";
  EXPECT_EQ(viewer_->shown_title(), "Offing: moving *");
  const std::vector<unsigned char> after = picture();
  EXPECT_FALSE(after == before);
  undo();
  EXPECT_EQ(times("camera.x_m")[1], 4.0);
  EXPECT_TRUE(picture() == before);
  redo();
  EXPECT_EQ(times("camera.x_m")[1], moved_s);
  EXPECT_TRUE(picture() == after);
  press_with_control("s");
  turn(2);
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_EQ(viewer_->shown_title(), "Offing: moving");
  present::ViewOptions again = quick_options();
  again.scene = scene::load_scene(folder_.path() / "moving.toml");
  open(again);
  EXPECT_EQ(times("camera.x_m")[1], moved_s);
  EXPECT_TRUE(picture() == after);
}

// Fails if Esc loses what is dragged, or an undo while the mouse holds keyframes is taken back by it.
TEST_F(WindowKeyframesTest, EscapeAndUndoWhileTheyAreHeld) {
  open(options_of(moving));
  const Spot from = on_keys(4.0), to = on_keys(6.0);
  const auto hold = [&] {
    hands_->move_to(from.x, from.y);
    turn();
    hands_->button(Hands::Button::left, Hands::Motion::down);
    turn();
    hands_->move_to(to.x, to.y);
    turn();
  };
  hold();
  press("Escape");
  hands_->button(Hands::Button::left, Hands::Motion::up);
  turn(2);
  EXPECT_NEAR(times("camera.x_m")[1], 6.0, 0.06);
  undo();
  ASSERT_EQ(times("camera.x_m")[1], 4.0);
  drag_keys(4.0, 3.0);
  hands_->move_to(on_keys(8.0).x, on_keys(8.0).y);
  turn();
  hands_->button(Hands::Button::left, Hands::Motion::down);
  turn();
  hands_->move_to(on_keys(7.0).x, on_keys(7.0).y);
  turn();
  undo();
  turn(2);
  hands_->button(Hands::Button::left, Hands::Motion::up);
  turn(2);
  EXPECT_EQ(times("camera.x_m"), (std::vector<double>{0.0, 4.0, 8.0}));
}

// Fails if the way back to the path forgets edits of its keyframes, or Up and Down do not go from keyframe to
// keyframe.
TEST_F(WindowKeyframesTest, PathsAreKeptWhenTheCameraLeaves) {
  open(options_of(moving));
  press("Up");
  EXPECT_EQ(state().clock.time_s(), 4.0);
  press("Down");
  EXPECT_EQ(state().clock.time_s(), 0.0);
  drag_keys(4.0, 3.0);
  const std::vector<double> edited = times("camera.x_m");
  drag({420, 100}, {440, 120});
  EXPECT_FALSE(state().scene.tracks.contains({"camera.x_m"}));
  press("0");
  turn();
  EXPECT_EQ(times("camera.x_m"), edited);
  press("Up");
  turn();
  EXPECT_EQ(state().clock.time_s(), edited[1]);
  EXPECT_NEAR(state().camera.camera().eye_m.x, 100.0, 1e-9);
  drag({420, 100}, {440, 120});
  undo();
  press("0");
  turn();
  EXPECT_EQ(times("camera.x_m")[1], 4.0) << "the edit is undone, also if the camera was elsewhere";
}

}  // namespace
}  // namespace offing::test
