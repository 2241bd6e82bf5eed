// Keys and mouse of the window.
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/geometric.hpp>

#include "host/io/png_image.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/schema/parameter_table.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using present::Fill;
using present::ViewAction;
using present::ViewState;

class WindowKeysTest : public WindowTest {
 protected:
  /// Holds a key for a few frames; how far the eye moved along right, up and forward, m.
  glm::dvec3 fly(const char* key) {
    const Camera start = state().camera.camera();
    hands_->key(key, Hands::Motion::down);
    turn(4);
    hands_->key(key, Hands::Motion::up);
    turn();
    const CameraBasis axes = basis(start);
    const glm::dvec3 way = state().camera.camera().eye_m - start.eye_m;
    return {glm::dot(way, axes.right), way.y, glm::dot(way, axes.forward)};
  }
};

// What X calls the keys whose names on the keyboard are others.
std::string x_name(const std::string& printed) {
  static const std::map<std::string, std::string> others{{"Space", "space"},    {".", "period"},
                                                         {",", "comma"},        {"[", "bracketleft"},
                                                         {"]", "bracketright"}, {"Backspace", "BackSpace"},
                                                         {"Esc", "Escape"}};
  const auto other = others.find(printed);
  if (other != others.end()) return other->second;
  return printed.size() == 1 ? std::string(1, static_cast<char>(std::tolower(printed.front()))) : printed;
}

// Fails if a key of the help does nothing, or something else.
TEST_F(WindowKeysTest, EveryKeyDoesWhatItSays) {
  open(quick_options());
  using Check = std::function<bool(const ViewState& before, const ViewState& after)>;
  const double frame_s = 1.0 / quick_options().scene.time.frames_per_second;
  const auto stepped = [](double by_s) {
    return [by_s](const ViewState& a, const ViewState& b) {
      return std::abs(b.clock.time_s() - a.clock.time_s() - by_s) < 1e-9;
    };
  };
  const auto says = [](const char* text) {
    return [text](const ViewState&, const ViewState& b) {
      return b.message.text.find(text) != std::string::npos;
    };
  };
  const auto scaled = [](double by) {
    return [by](const ViewState& a, const ViewState& b) { return b.clock.scale() == a.clock.scale() * by; };
  };
  const std::map<ViewAction, Check> checks{
      {ViewAction::toggle_help, [](const auto& a, const auto& b) { return a.shows_help != b.shows_help; }},
      {ViewAction::toggle_panels,
       [](const auto& a, const auto& b) { return a.shows_panels != b.shows_panels; }},
      {ViewAction::toggle_pause,
       [](const auto& a, const auto& b) { return a.clock.is_paused() != b.clock.is_paused(); }},
      {ViewAction::step_forward, stepped(frame_s)},
      {ViewAction::step_back, stepped(-frame_s)},
      {ViewAction::first_frame, [](const auto&, const auto& b) { return b.clock.time_s() == 0.0; }},
      {ViewAction::last_frame,
       [=](const auto&, const auto& b) { return std::abs(b.clock.time_s() + frame_s - 2.0) < 1e-9; }},
      {ViewAction::next_key, stepped(0.0)},  // window_keyframes_test.cpp
      {ViewAction::previous_key, stepped(0.0)},
      {ViewAction::toggle_loop,
       [](const auto& a, const auto& b) { return a.timeline.loops != b.timeline.loops; }},
      {ViewAction::slower, scaled(0.5)},
      {ViewAction::faster, scaled(2.0)},
      {ViewAction::real_time, [](const auto&, const auto& b) { return b.clock.scale() == 1.0; }},
      {ViewAction::toggle_wireframe, [](const auto& a, const auto& b) { return a.fill != b.fill; }},
      {ViewAction::next_debug_view, [](const auto& a, const auto& b) { return a.debug != b.debug; }},
      {ViewAction::next_mesh_show, [](const auto& a, const auto& b) { return a.meshes != b.meshes; }},
      {ViewAction::toggle_walk,
       [](const auto&, const auto& b) { return b.message.text.find("no ground") != std::string::npos; }},
      {ViewAction::toggle_steps, [](const auto& a, const auto& b) { return a.terrain != b.terrain; }},
      {ViewAction::toggle_map, [](const auto& a, const auto& b) { return a.shows_map != b.shows_map; }},
      {ViewAction::pick_ray, [](const auto&, const auto& b) { return !b.pick; }},  // window_terrain_test.cpp
      {ViewAction::take_screenshot,
       [](const auto&, const auto& b) { return b.message.text.find("wrote ") == 0 && !b.message.is_fault; }},
      {ViewAction::reload,
       [](const auto&, const auto& b) { return b.message.text.find("compiled again") != std::string::npos; }},
      {ViewAction::reset_camera,
       [](const auto&, const auto& b) {
         return b.camera.camera().eye_m == quick_options().scene.view.camera.eye_m;
       }},
      {ViewAction::look_at_selected, says("nothing with a place is selected")},
      {ViewAction::set_keyframes, says("no highlight is picked")},
      {ViewAction::next_cloud_pick, says("clicks on clouds pick")},
      {ViewAction::place_ball, says("clicks place balls")},
      {ViewAction::place_cloud, says("clicks place clouds")},
      {ViewAction::duplicate_picked, says("nothing is selected that can be copied")},
      {ViewAction::remove_picked, says("nothing is selected")},
      {ViewAction::deselect,
       [](const auto& a, const auto& b) {
         return a.clouds.tool != present::CloudTool::pick && b.clouds.tool == present::CloudTool::pick;
       }},
  };
  fly("w");  // for reset_camera
  for (const present::KeyBinding& binding : present::key_bindings()) {
    if (binding.action == ViewAction::toggle_fullscreen) continue;  // FullScreenAndBack
    if (binding.modifiers != 0) continue;  // window_highlights_test.cpp, window_quit_test.cpp
    if (binding.keys > 1) continue;        // window_bookmarks_test.cpp
    if (!state().clock.is_paused()) press("space");
    const auto check = checks.find(binding.action);
    ASSERT_NE(check, checks.end()) << binding.name << " is not tested";
    if (state().shows_help) press("h");  // else Esc closes that first
    const ViewState before = state();
    press(x_name(binding.name).c_str());
    EXPECT_TRUE(check->second(before, state())) << binding.name << ": " << binding.help << "; " << message();
  }
  EXPECT_TRUE(viewer_->turn());
}

// Fails if full screen is not as large as the screen, or does not end as it began.
TEST_F(WindowKeysTest, FullScreenAndBack) {
  open(quick_options());
  const int before = width() * 1000 / height();
  press("F11");
  turn(3);
  EXPECT_NEAR(width() * 1000 / height(), 1250, 5) << "of the screen, 1280 x 1024";
  press("F11");
  turn(3);
  EXPECT_EQ(width() * 1000 / height(), before);
}

// Fails if keys fly along other axes than those of the picture, or Shift and the wheel do not change the
// speed.
TEST_F(WindowKeysTest, FliesWithTheUsualKeys) {
  open(quick_options());
  look_at_sea();
  struct Way {
    const char* key;
    int axis;
    double sign;
  };
  // Up and down first: the eye stops above the water.
  for (const Way way : {Way{"e", 1, 1.0}, Way{"q", 1, -1.0}, Way{"d", 0, 1.0}, Way{"a", 0, -1.0},
                        Way{"w", 2, 1.0}, Way{"s", 2, -1.0}}) {
    const glm::dvec3 moved = fly(way.key);
    EXPECT_GT(way.sign * moved[way.axis], 0.05) << way.key;
    EXPECT_GT(std::abs(moved[way.axis]), 0.5 * glm::length(moved)) << way.key;
  }
  const double usual_mps = state().camera.speed_mps();
  hands_->button(Hands::Button::wheel_up, Hands::Motion::down);
  hands_->button(Hands::Button::wheel_up, Hands::Motion::up);
  turn();
  EXPECT_GT(state().camera.speed_mps(), usual_mps);
}

// Fails if a letter flies while Ctrl is held, or once Ctrl is up and the letter is not yet, or Alt does not
// make flying slower.
TEST_F(WindowKeysTest, ControlDoesNotFlyAndAltIsSlow) {
  open(quick_options());
  for (const char* key : {"w", "a", "s", "d", "e", "q"}) {
    const glm::dvec3 before_m = state().camera.camera().eye_m;
    hands_->key("Control_L", Hands::Motion::down);
    hands_->key(key, Hands::Motion::down);
    turn(2);
    hands_->key("Control_L", Hands::Motion::up);
    turn(2);
    hands_->key(key, Hands::Motion::up);
    turn();
    EXPECT_EQ(state().camera.camera().eye_m, before_m) << key;
    if (*key == 'q') open(quick_options());
  }
  hands_->key("Alt_L", Hands::Motion::down);
  const double start_s = glfwGetTime();
  const glm::dvec3 moved_m = fly("e");
  const double lasted_s = glfwGetTime() - start_s;
  hands_->key("Alt_L", Hands::Motion::up);
  EXPECT_GT(moved_m.y, 0.0);
  EXPECT_LE(moved_m.y, 0.2 * state().camera.speed_mps() * lasted_s);
}

// Fails if a frame that stands still for long throws the camera as far as it would have flown meanwhile.
TEST_F(WindowKeysTest, FramesThatStandStillMoveItLittle) {
  open(quick_options());
  hands_->key("e", Hands::Motion::down);
  turn(2);
  const glm::dvec3 before_m = state().camera.camera().eye_m;
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  turn();
  hands_->key("e", Hands::Motion::up);
  const double moved_m = glm::length(state().camera.camera().eye_m - before_m);
  EXPECT_GT(moved_m, 0.0);
  EXPECT_LE(moved_m, 0.26 * state().camera.speed_mps());
}

// Fails if the camera does not follow its keyframes, keeps from the user, or key 0 does not take it back.
TEST_F(WindowKeysTest, FollowsThePathUntilItIsMoved) {
  present::ViewOptions options = quick_options();
  options.scene = scene::parse_scene(
      "version = 1\n[ocean]\nsize = 64\n[camera]\npitch_deg = 60\n"
      "x_m = { keys = [{ t = 0, value = 0 }, { t = 100, value = 1000 }], interpolation = \"linear\" }\n",
      "path.toml", "");
  open(options);
  const auto eye_x_m = [&] { return state().camera.camera().eye_m.x; };
  const auto path_x_m = [&] { return 10.0 * state().clock.time_s(); };
  EXPECT_NEAR(eye_x_m(), path_x_m(), 1e-9);
  press("period");
  EXPECT_NEAR(eye_x_m(), path_x_m(), 1e-9);
  fly("d");
  const double left_m = eye_x_m();
  press("period");
  EXPECT_EQ(eye_x_m(), left_m);
  EXPECT_TRUE(state().scene.tracks.empty()) << "what is saved is where the camera is";
  press("0");
  turn();
  EXPECT_NEAR(eye_x_m(), path_x_m(), 1e-9);
  EXPECT_EQ(state().scene.tracks.size(), 1u);
}

// Fails if letters that are typed into a field of the panels fly the camera or open the help.
TEST_F(WindowKeysTest, TypingIsNotFlying) {
  open(quick_options());
  toggle_header("Sun");
  const Camera before = state().camera.camera();
  click(find(values(), present::parameter_label(*scene::find_parameter("sun.time_utc"))));
  type("wash_h");
  EXPECT_FALSE(state().shows_help);
  EXPECT_EQ(state().camera.camera().eye_m, before.eye_m);
}

// Fails if a drag over a panel turns the camera.
TEST_F(WindowKeysTest, PanelsKeepTheirDrags) {
  open(quick_options());
  const double before = state().camera.camera().pitch_rad;
  const Spot slider = find(timeline(), "##time scale", 400);
  drag(slider, {slider.x + 300, slider.y - 300});
  EXPECT_EQ(state().camera.camera().pitch_rad, before);
  EXPECT_GT(state().clock.scale(), 1.0);
}

// Fails if a picture replaces another one, or shows the panels or anything else than the sea.
TEST_F(WindowKeysTest, PicturesNeverReplaceEachOther) {
  open(quick_options());
  press("F12");
  EXPECT_NE(message().find((std::filesystem::canonical(folder_.path()) / "offing_001.png").string()),
            std::string::npos)
      << message();
  look_at_sea();
  const std::vector<unsigned char> shown = picture();  // which stays as it is
  press("F12");
  const RgbImage first = read_png("offing_001.png"), second = read_png("offing_002.png");
  EXPECT_EQ(second.width, width());
  EXPECT_EQ(second.height, height());
  EXPECT_NE(first.rgb, second.rgb);
  // OpenGL's first row is at the bottom.
  const auto row = static_cast<std::ptrdiff_t>(3 * width());
  EXPECT_TRUE(std::equal(second.rgb.begin(), second.rgb.begin() + row, shown.end() - row));
}

}  // namespace
}  // namespace offing::test
