// The timeline at the bottom of the window.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
// Windows of the panels, which only ImGui knows.
#include <imgui_internal.h>

#include "host/scene/file/scene_file.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

class WindowTimelineTest : public WindowTest {
 protected:
  double time_s() const { return state().clock.time_s(); }
  double frame_s() const { return 1.0 / state().scene.time.frames_per_second; }
  /// In the bar of the scene's time span, whose ends can be pulled.
  Spot on_bar(double time_s) const {
    const float strip_px = 2.4f * ImGui::GetFontSize();
    const Spot below = on_timeline(time_s);
    return {below.x, below.y - static_cast<int>(strip_px - ImGui::GetFontSize()) + 3};
  }
  void drag_time(double from_s, double to_s) {
    const Spot from = on_timeline(from_s), to = on_timeline(to_s);
    pull({from.x, from.y}, {to.x, to.y});
  }
};

// Fails if a button, the slider of the speed or the field of the time does not do what it says.
TEST_F(WindowTimelineTest, Buttons) {
  open(quick_options());
  const double start_s = time_s();
  click(find(timeline(), "step forward", 150));
  EXPECT_NEAR(time_s(), start_s + frame_s(), 1e-9);
  click(find(timeline(), "step back", 125));
  EXPECT_NEAR(time_s(), start_s, 1e-9);
  click(find(timeline(), "|<##first frame", 90));
  EXPECT_EQ(time_s(), 0.0);
  click(find(timeline(), ">|##last frame", 180));
  EXPECT_NEAR(time_s(), 2.0 - frame_s(), 1e-9);
  enter(find(timeline(), "##time", 230), "1.25");
  EXPECT_EQ(time_s(), 1.25);
  const Spot scale = find(timeline(), "##time scale", 400);
  drag(scale, {scale.x + 20, scale.y});
  EXPECT_GT(state().clock.scale(), 1.0);
  click(find(timeline(), "play##clock", 30));
  EXPECT_FALSE(state().clock.is_paused());
  EXPECT_GT(time_s(), 1.25);
  click(find(timeline(), "pause##clock", 30));
  EXPECT_TRUE(state().clock.is_paused());
}

// Fails if the mouse drags time elsewhere than to the frame below it, a pause ends or a run stays paused, or
// an earlier time looks otherwise than it did.
TEST_F(WindowTimelineTest, ScrubsThereAndBack) {
  present::ViewOptions options = quick_options();
  options.time_s = 1.0;
  open(options);
  look_at_sea();
  const std::vector<unsigned char> first = picture();
  drag_time(1.0, 1.75);
  EXPECT_NEAR(time_s(), 1.75, 1.0 / 200.0) << "the nearest of 24 frames a second";
  EXPECT_NEAR(std::remainder(time_s(), frame_s()), 0.0, 1e-9);
  EXPECT_TRUE(state().clock.is_paused());
  EXPECT_FALSE(picture() == first);
  drag_time(time_s(), 1.0);
  EXPECT_EQ(time_s(), 1.0);
  EXPECT_TRUE(picture() == first);
  EXPECT_EQ(edited_text().find("end_s"), std::string::npos) << "scrubbing is no edit";
  press("space");
  const Spot early = on_timeline(0.5);
  hands_->move_to(early.x, early.y);
  turn();
  hands_->button(Hands::Button::left, Hands::Motion::down);
  turn(3);
  EXPECT_NEAR(time_s(), 0.5, 0.5 * frame_s()) << "time stands while it is held";
  hands_->button(Hands::Button::left, Hands::Motion::up);
  turn(2);
  EXPECT_FALSE(state().clock.is_paused());
}

// Fails if wakes and floating bodies, which have a past, are elsewhere at an earlier time than they were.
TEST_F(WindowTimelineTest, BodiesAndTheirWakesGoBack) {
  present::ViewOptions options = quick_options();
  options.scene = scene::parse_scene(
      "version = 1\n[time]\nend_s = 4\n[ocean]\nsize = 32\n[[ocean.wake]]\nlength_m = 64\ncells = 64\n"
      "history_s = 1\ncentre = \"body\"\nbody = \"boat\"\n[camera]\ny_m = 4\nz_m = 12\npitch_deg = -15\n"
      "[[mesh]]\nname = \"hull\"\nshape = \"boat\"\n[[body]]\nname = \"boat\"\nmesh = \"hull\"\n"
      "draught_m = 0.15\nspeed_mps = 2\nthrust_n = 500\n",
      "boat.toml", "");
  options.time_s = 1.0;
  open(options);
  const std::vector<unsigned char> first = picture();
  drag_time(1.0, 3.0);
  EXPECT_FALSE(picture() == first);
  drag_time(3.0, 1.0);
  ASSERT_EQ(time_s(), 1.0);
  EXPECT_TRUE(picture() == first);
}

// Fails if a loop leaves the scene's time span, or time stops at its end without one.
TEST_F(WindowTimelineTest, Loops) {
  present::ViewOptions options = quick_options();
  options.scene.time.end_s = 0.5;
  options.time_s = 0.25;
  open(options);
  press("bracketright");
  press("l");
  press("space");
  double latest_s = 0.0;
  bool has_begun_anew = false;
  const double end_s = glfwGetTime() + 20.0;
  while (!has_begun_anew && glfwGetTime() < end_s) {
    const double before_s = time_s();
    turn();
    has_begun_anew = time_s() < before_s;
    latest_s = std::max(latest_s, time_s());
  }
  EXPECT_TRUE(has_begun_anew);
  EXPECT_LT(latest_s, 0.5);
  press("l");
  while (time_s() < 0.6 && glfwGetTime() < end_s) turn();
  EXPECT_GE(time_s(), 0.6);
}

// Fails if the ends of the scene's time span cannot be pulled, are pulled without an undo, or Esc loses what
// the mouse holds.
TEST_F(WindowTimelineTest, PullsTheEndsOfTheSpan) {
  present::ViewOptions options = quick_options();
  options.scene.time.end_s = 8.0;
  open(options);
  const std::string before = edited_text();
  const Spot end = on_bar(8.0), to = on_bar(5.0);
  hands_->move_to(end.x - 2, end.y);
  turn();
  hands_->button(Hands::Button::left, Hands::Motion::down);
  turn();
  hands_->move_to(to.x, to.y);
  turn();
  press("Escape");
  hands_->button(Hands::Button::left, Hands::Motion::up);
  turn(2);
  EXPECT_NEAR(state().scene.time.end_s, 5.0, 0.05);
  EXPECT_EQ(time_s(), 2.0);
  const std::string after = edited_text();
  undo();
  EXPECT_EQ(edited_text(), before);
  redo();
  EXPECT_EQ(edited_text(), after);
  save_as("shorter.toml");
  EXPECT_EQ(scene::load_scene("shorter.toml").time.end_s, state().scene.time.end_s) << message();
}

}  // namespace
}  // namespace offing::test
