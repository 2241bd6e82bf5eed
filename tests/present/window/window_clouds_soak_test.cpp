// Random edits of clouds for a while: OFFING_SOAK_SECONDS, or 30 s.
#include <algorithm>
#include <array>
#include <optional>
#include <random>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "present/editing/cloud_editor.h"
#include "tests/present/editing/holdings.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

constexpr const char* scene_text = R"(version = 1
[camera]
y_m = 300
z_m = 1800
pitch_deg = 25
fov_deg = 50
[[cloud]]
y_m = 1000
[[cloud.ball]]
radius_m = 150
)";

class WindowCloudsSoakTest : public WindowTest {
 protected:
  /// One thing that an artist does, whichever; a sky that becomes too full is thinned out again.
  void do_something() {
    static constexpr std::array keys{"o", "o", "b", "c", "j", "Delete", "0", "Tab"};
    std::size_t balls = 0;
    for (const scene::CloudScene& cloud : state().scene.clouds) balls += cloud.balls.size();
    if (state().scene.clouds.size() > most_clouds || balls > most_balls) {
      hold({"Control_L"}, [&] { press("z"); });
      hold({"Control_L"}, [&] { press("z"); });
    }
    switch (pick(0, 9)) {
      case 0:
      case 1:
        press(keys[static_cast<std::size_t>(pick(0, static_cast<int>(keys.size()) - 1))]);
        break;
      case 2:
        hold({"Control_L"}, [&] { press("z"); });
        break;
      case 3:
        hold({"Control_L", "Shift_L"}, [&] { press("z"); });
        break;
      case 4:
      case 5:
        hold({"Shift_L"}, [&] { drag_from(anywhere()); });
        break;
      case 6:
        pull_handle();
        break;
      case 7:
        use_panel();
        break;
      default:
        click(anywhere());
    }
  }

  /// What the process holds once nothing is being made.
  Holdings holdings_at_rest() {
    wait_for_clouds();
    turn(3);
    return holdings();
  }

  void hide_main_panel() {
    ImGui::SetWindowCollapsed("Offing", true);
    turn(2);
  }

 private:
  static constexpr std::size_t most_clouds = 4, most_balls = 20;

  int pick(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
  Spot anywhere() { return {pick(0, 470), pick(40, 690)}; }

  template <class Work>
  void hold(const std::vector<const char*>& held, const Work& work) {
    for (const char* name : held) hands_->key(name, Hands::Motion::down);
    turn();
    work();
    for (const char* name : held) hands_->key(name, Hands::Motion::up);
    turn();
  }
  void drag_from(Spot from) { drag(from, {from.x + pick(-60, 60), from.y + pick(-60, 60)}); }

  /// As it is at the time: often while clouds are being made.
  void pull_handle() {
    const present::ShownClouds shown{state().scene, viewer_->sea().clouds(), state().clock.time_s()};
    const bool is_lost =
        std::any_of(state().clouds.picked.begin(), state().clouds.picked.end(),
                    [&](const present::CloudPart& part) { return !present::has_part(state().scene, part); });
    if (is_lost) return;
    const std::optional<present::Sphere> sphere = present::held_sphere(state(), shown);
    if (!sphere) return;
    int width = 1, height = 1;
    glfwGetWindowSize(viewer_->window(), &width, &height);
    const auto places = present::object_handle_places({state().camera.camera(), {width, height}}, *sphere,
                                                      present::cloud_handles(state()));
    if (places.empty()) return;
    const glm::dvec2 px =
        places[static_cast<std::size_t>(pick(0, static_cast<int>(places.size()) - 1))].place_px;
    if (px.x < 0.0 || px.y < 0.0 || px.x >= width || px.y >= height) return;
    const Spot from{static_cast<int>(px.x), static_cast<int>(px.y)};
    if (pick(0, 1) == 0) {
      drag_from(from);
    } else {
      hold({"Control_L"}, [&] { drag_from(from); });
    }
  }

  /// Of the editor.
  void use_panel() {
    const ImGuiWindow* panel = ImGui::FindWindowByName("Cloud editor");
    if (panel == nullptr || !panel->WasActive) return;
    const Spot from{static_cast<int>(panel->Pos.x) + pick(5, static_cast<int>(panel->Size.x) - 5),
                    static_cast<int>(panel->Pos.y) + pick(22, static_cast<int>(panel->Size.y) - 5)};
    drag(from, {from.x + pick(-30, 30), from.y + pick(-15, 15)});
  }

  std::mt19937 random_{20'090'601};
};

// Fails if the editor cannot take what artists do for long: an OpenGL error, an exception, a scene that
// cannot be read back, or memory, threads or descriptors that grow. Memory: at the end within 15 % of what
// there was after the first quarter; a sky of four clouds and a hundred steps of undo differ by some MB.
TEST_F(WindowCloudsSoakTest, TakesWhateverComes) {
  present::ViewOptions options = quick_options();
  options.scene = scene::parse_scene(scene_text, "sky.toml", "");
  open(options);
  glfwSetWindowSize(viewer_->window(), 480, 700);
  turn(3);
  hide_main_panel();
  const double lasts_s = soak_seconds(30.0), end_s = glfwGetTime() + lasts_s;
  const double warm_s = end_s - 0.75 * lasts_s;
  std::optional<Holdings> warm;
  int deeds = 0, faults = 0;
  double largest_mb = 0.0;
  while (glfwGetTime() < end_s) {
    do_something();
    ++deeds;
    if (state().message.is_fault) ++faults;
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "after deed " << deeds;
    if (deeds % 20 == 0) {
      const std::string text = scene::scene_text(state().scene, "");
      ASSERT_EQ(scene::scene_text(scene::parse_scene(text, "soak.toml", ""), ""), text);
    }
    largest_mb = std::max(largest_mb, holdings().memory_mb);
    if (!warm && glfwGetTime() > warm_s) warm = holdings_at_rest();
  }
  const Holdings last = holdings_at_rest();
  ASSERT_TRUE(warm);
  fmt::print(
      "{} deeds, {} with a fault told; memory {:.0f} -> {:.0f} MB (most {:.0f}), threads {} -> {}, "
      "descriptors {} -> {}\n",
      deeds, faults, warm->memory_mb, last.memory_mb, largest_mb, warm->threads, last.threads,
      warm->descriptors, last.descriptors);
  EXPECT_LT(last.memory_mb, 1.15 * warm->memory_mb);
  EXPECT_EQ(last.threads, warm->threads);
  EXPECT_EQ(last.descriptors, warm->descriptors);
}

}  // namespace
}  // namespace offing::test
