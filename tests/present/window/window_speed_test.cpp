// How fast and how sharp a window is where the CPU draws: 1280 x 720 pixels, scenes that come with Offing.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "host/scene/file/scene_file.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

struct SpeedCase {
  const char* scene;
  const char* held_key;  // "": time alone moves the scene
};

class WindowSpeedTest : public WindowTest, public testing::WithParamInterface<SpeedCase> {};

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Prints when the first picture comes, how many frames a second a view has that moves and how large they are,
// and when it is sharp once it stands. Fails if it is never sharp, or does not give way to frames: the rest
// is the machine's.
TEST_P(WindowSpeedTest, OfShippedScenes) {
  constexpr int width = 1280, height = 720;
  constexpr double settled_s = 15.0, watched_s = 8.0, longest_s = 60.0;
  present::ViewOptions options;
  options.scene = scene::load_scene(std::filesystem::path(OFFING_SOURCES) / "scenes" / GetParam().scene);
  options.time_s = options.scene.time.start_s;
  options.verbosity = Verbosity::quiet;
  const double start_s = seconds();
  viewer_ = std::make_unique<present::Viewer>(options, cancel_);
  turn();
  const double first_s = seconds() - start_s;
  glfwSetWindowSize(viewer_->window(), width, height);
  const std::string key = GetParam().held_key;
  turn(3);
  if (!key.empty()) hands_->key(key, Hands::Motion::down);
  const double moving_s = glfwGetTime();
  std::vector<double> frames_s;
  double frame_s = moving_s;
  while (glfwGetTime() < moving_s + settled_s + watched_s) {
    turn();
    const double now_s = glfwGetTime();
    if (now_s > moving_s + settled_s) frames_s.push_back(now_s - frame_s);
    frame_s = now_s;
  }
  if (!key.empty()) hands_->key(key, Hands::Motion::up);
  const present::Quality quality = viewer_->quality();
  const double side_share = static_cast<double>(this->width()) / width;
  ASSERT_GE(frames_s.size(), 3u);
  std::sort(frames_s.begin(), frames_s.end());
  const double median_hz = 1.0 / frames_s[frames_s.size() / 2];
  if (key.empty()) press("space");
  const double stood_s = glfwGetTime();
  while (!viewer_->is_sharp() && glfwGetTime() < stood_s + longest_s) turn();
  const double sharp_s = glfwGetTime() - stood_s;
  fmt::print(
      "{}: first picture after {:.2f} s; {:.1f} frames a second at {:.0f} % of the sides; sharp after {:.2f} "
      "s\n",
      GetParam().scene, first_s, median_hz, 100.0 * side_share, sharp_s);
  EXPECT_TRUE(viewer_->is_sharp());
  EXPECT_EQ(this->width(), width);
  EXPECT_TRUE(median_hz > 0.8 * 20.0 || quality == present::quality_levels.back()) << median_hz;
}

INSTANTIATE_TEST_SUITE_P(Scenes, WindowSpeedTest,
                         testing::Values(SpeedCase{"world.toml", ""}, SpeedCase{"storm.toml", ""},
                                         SpeedCase{"cumulus.toml", ""}, SpeedCase{"valley_walk.toml", "w"}),
                         [](const auto& speed_case) {
                           return std::filesystem::path(speed_case.param.scene).stem().string();
                         });

}  // namespace
}  // namespace offing::test
