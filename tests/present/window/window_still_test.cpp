// Views that stand still: they get as sharp as pictures in files, and then nothing is drawn any more.
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "host/scene/file/scene_file.h"
#include "present/output/scene_images.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

constexpr int still_width = 320, still_height = 180;

class WindowStillTest : public WindowTest {
 protected:
  void open_small(const present::ViewOptions& options) {
    open(options);
    glfwSetWindowSize(viewer_->window(), still_width, still_height);
    hands_->move_to(still_width - 5, still_height - 5);
    turn(3);
  }

  /// Turns until nothing is left to draw; how long that took.
  double rest() {
    constexpr double longest_s = 30.0;
    const double start_s = glfwGetTime();
    while (!viewer_->is_at_rest()) {
      turn();
      if (glfwGetTime() - start_s > longest_s) {
        ADD_FAILURE() << "the window never rests";
        break;
      }
    }
    return glfwGetTime() - start_s;
  }

  /// Bytes of a window's picture that differ from the one that the same scene has in a file.
  std::size_t differences_from_file(const scene::Scene& scene) {
    const std::vector<unsigned char> shown = picture();
    const double time_s = state().clock.time_s();
    EXPECT_EQ(width(), still_width);
    EXPECT_EQ(height(), still_height);
    viewer_.reset();  // OpenGL has one context at a time
    present::SceneImages images(scene, ocl::select_device(""), present::frame_settings(present::Detail::high),
                                cancel_);
    images.draw(time_s, time_s, {still_width, still_height}, cancel_);
    const std::vector<unsigned char> filed = images.frame().screen().read_bytes();
    std::size_t differences = shown.size() == filed.size() ? 0 : filed.size();
    for (std::size_t i = 0; differences < filed.size() && i < filed.size(); ++i)
      differences += shown[i] != filed[i] ? 1 : 0;
    return differences;
  }
};

present::ViewOptions still_options(present::ViewOptions options, const char* scene) {
  options.scene = scene::load_scene(std::filesystem::path(OFFING_SOURCES) / "scenes" / scene);
  options.time_s = options.scene.time.start_s;
  options.render_scale = 1.0;
  options.detail.reset();
  return options;
}

// Fails if a paused view stays coarse, differs in one bit from the picture in a file, or goes on being drawn.
TEST_F(WindowStillTest, GetsAsSharpAsFilesAndRests) {
  present::ViewOptions options = still_options(quick_options(), "cumulus.toml");
  options.kept_hz = 20.0;
  open_small(options);
  press("space");
  turn(20);  // at whatever quality
  press("space");
  ASSERT_TRUE(state().clock.is_paused());
  ASSERT_GT(state().clock.time_s(), options.time_s);
  const double waited_s = rest();
  fmt::print("at rest after {:.2f} s\n", waited_s);

  // An idle window may wake four times a second and take 1 ms each time: 0.4 % of a core. A drawn frame takes
  // 5 ms or more.
  const std::clock_t before = std::clock();
  const double start_s = glfwGetTime();
  while (glfwGetTime() - start_s < 2.0) turn();
  const double busy_s = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  EXPECT_LT(busy_s, 0.02 * (glfwGetTime() - start_s));

  EXPECT_EQ(differences_from_file(options.scene), 0u);
}

}  // namespace
}  // namespace offing::test
