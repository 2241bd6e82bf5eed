// Random keys and mouse for a while: OFFING_SOAK_SECONDS, or 20 s.
#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <string_view>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "host/scene/parameter_table.h"
#include "present/parameter_widget.h"
#include "tests/present/holdings.h"
#include "tests/present/window_test.h"

namespace offing::test {
namespace {

class WindowSoakTest : public WindowTest {
 protected:
  /// One thing that a user does, whichever. Not: Esc, which ends the window, and the size of the patches,
  /// which ends where the memory does; and other scenes.
  void do_something() {
    static constexpr std::array keys{
        "h",         "Tab", "space", "period", "comma", "bracketleft", "bracketright",
        "BackSpace", "g",   "v",     "F11",    "Home",  "w",           "a",
        "s",         "d",   "q",     "e"};
    switch (pick(0, 11)) {
      case 0:
      case 1:
      case 2:
        press(keys[static_cast<std::size_t>(pick(0, static_cast<int>(keys.size()) - 1))]);
        break;
      case 3:
        if (pick(0, 9) == 0) press(pick(0, 1) == 0 ? "F5" : "F12");
        break;
      case 4:
        glfwSetWindowSize(viewer_->window(), pick(1, 900), pick(1, 1000));
        turn(2);
        break;
      case 5: {
        const Hands::Button wheel = pick(0, 1) == 0 ? Hands::Button::wheel_up : Hands::Button::wheel_down;
        hands_->button(wheel, Hands::Motion::down);
        hands_->button(wheel, Hands::Motion::up);
        turn();
        break;
      }
      case 6:
        hands_->type(fmt::format("{}", pick(0, 99)));
        press("Return");
        break;
      default:
        use_mouse();
    }
  }

  /// What the process holds with the window as large as at the start.
  Holdings holdings_as_at_start() {
    if (glfwGetWindowMonitor(viewer_->window()) != nullptr) press("F11");
    glfwSetWindowSize(viewer_->window(), width_, height_);
    turn(3);
    return holdings();
  }

  int width_ = 0, height_ = 0;

  int pick(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }

 private:
  void use_mouse() {
    // Mostly on the panels.
    const Spot from{pick(0, pick(0, 3) == 0 ? 900 : 350), pick(0, 1000)};
    hands_->move_to(from.x, from.y);
    turn();
    // Another scene is another amount of memory.
    const ImGuiWindow* over = ImGui::GetCurrentContext()->HoveredWindow;
    const std::string_view name = over == nullptr ? "" : over->Name;
    if (name.find("/beside_") != name.npos || name.find("/shipped_") != name.npos) return;
    ImGuiWindow* panel = main_panel();
    const scene::Parameter& size = *scene::find_parameter("ocean.size");
    const unsigned hovered = ImGui::GetCurrentContext()->HoveredId;
    if (panel != nullptr && panel->WasActive &&
        hovered == panel->GetID(present::parameter_label(size).c_str()))
      return;
    drag(from, {from.x + pick(-60, 60), from.y + pick(-20, 20)});
  }

  std::mt19937 random_{20'071'204};
};

// Fails if the window cannot take what users do for long: an OpenGL error, an exception, or memory, threads
// or descriptors that grow. Memory: at the end within 10 % of what there was after the first quarter, both in
// a window of the usual size; what the scene has become by then differs, by swells and pictures of some MB.
TEST_F(WindowSoakTest, TakesWhateverComes) {
  open(quick_options());
  glfwGetWindowSize(viewer_->window(), &width_, &height_);
  press("F5");  // what is compiled again stays loaded
  const double lasts_s = soak_seconds(20.0), end_s = glfwGetTime() + lasts_s;
  const double warm_s = end_s - 0.75 * lasts_s;
  std::optional<Holdings> warm;
  int deeds = 0;
  double largest_mb = 0.0;
  while (glfwGetTime() < end_s) {
    do_something();
    ++deeds;
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "after deed " << deeds;
    largest_mb = std::max(largest_mb, holdings().memory_mb);
    if (!warm && glfwGetTime() > warm_s) warm = holdings_as_at_start();
  }
  const Holdings last = holdings_as_at_start();
  ASSERT_TRUE(warm);
  fmt::print("{} deeds; memory {:.0f} -> {:.0f} MB (most {:.0f}), threads {} -> {}, descriptors {} -> {}\n",
             deeds, warm->memory_mb, last.memory_mb, largest_mb, warm->threads, last.threads,
             warm->descriptors, last.descriptors);
  EXPECT_LT(last.memory_mb, 1.1 * warm->memory_mb);
  EXPECT_EQ(last.threads, warm->threads);
  EXPECT_EQ(last.descriptors, warm->descriptors);
}

}  // namespace
}  // namespace offing::test
