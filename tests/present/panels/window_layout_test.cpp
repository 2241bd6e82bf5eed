// Where panels lie in windows of usual sizes, how they look, and what windows remember of that.
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
// Windows of the panels, which only ImGui knows.
#include <imgui_internal.h>

#include "host/scene/schema/parameter_table.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

class WindowLayoutTest : public WindowTest {
 protected:
  void resize(int width, int height) {
    glfwSetWindowSize(viewer_->window(), width, height);
    turn(5);
  }
  /// Panels that the user sees, without the children within them and the bar at the main one's edge.
  static std::vector<const ImGuiWindow*> panels() {
    std::vector<const ImGuiWindow*> found;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      const std::string_view name = window->Name;
      const bool is_panel = window->WasActive && window->ParentWindow == nullptr && !window->Hidden;
      if (is_panel && name != "Debug##Default" && name != "panel edge") found.push_back(window);
    }
    return found;
  }
  /// Terrain, clouds, a mesh and a message: all panels at once.
  static present::ViewOptions full_options() {
    present::ViewOptions options = quick_options();
    scene::Scene& scene = options.scene;
    scene.ocean.is_given = true;
    scene.terrain.is_given = true;
    scene.terrain.fractal = {.posts = 65, .side_m = 2000.0, .relief_m = 300.0, .longest_m = 1500.0};
    scene.view.camera.eye_m = {0.0, 1200.0, 500.0};
    return options;
  }
  void expect_order(int width, int height) {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    resize(width, height);
    const std::vector<const ImGuiWindow*> all = panels();
    EXPECT_EQ(all.size(), 6u) << "main panel, cloud editor or keys, map, legend, message, timeline";
    for (const ImGuiWindow* one : all) {
      EXPECT_GE(one->Pos.x, 0.0f) << one->Name;
      EXPECT_GE(one->Pos.y, 0.0f) << one->Name;
      EXPECT_LE(one->Pos.x + one->Size.x, static_cast<float>(width)) << one->Name;
      EXPECT_LE(one->Pos.y + one->Size.y, static_cast<float>(height)) << one->Name;
      for (const ImGuiWindow* other : all) {
        if (other == one) break;
        EXPECT_FALSE(one->Rect().Overlaps(other->Rect())) << one->Name << " and " << other->Name;
      }
    }
  }
  void keep_look(double text_scale) const {
    std::filesystem::create_directories(folder_.path() / "state" / "offing");
    std::ofstream(folder_.path() / "state" / "offing" / "look") << "text_scale " << text_scale << '\n';
  }
};

// Fails if a panel leaves the window, or one covers another: at four usual sizes, the last with letters of
// twice the height.
TEST_F(WindowLayoutTest, NothingIsCoveredOrClipped) {
  for (const bool is_large : {false, true}) {
    keep_look(is_large ? 2.0 : 1.0);
    open(full_options());
    press("m");
    press("t");
    press("c");
    ASSERT_FALSE(message().empty());
    if (is_large) {
      expect_order(3840, 2160);
      continue;
    }
    toggle_header("Wind");
    toggle_header("Sun");
    expect_order(900, 500);
    press("c");
    press("h");
    expect_order(900, 500);
    expect_order(1280, 720);
    expect_order(1920, 1080);
  }
}

// Fails if the name of a value is cut off at the panel's edge, or at its scrollbar.
TEST_F(WindowLayoutTest, NamesOfValuesFit) {
  open(quick_options());
  ASSERT_FALSE(main_panel()->ScrollbarY);
  const float room = main_panel()->WorkRect.GetWidth() - ImGui::GetStyle().ScrollbarSize;
  const ImGuiStyle& style = ImGui::GetStyle();
  for (const scene::Parameter& row : scene::parameter_table()) {
    float taken = present::item_share * room + style.ItemInnerSpacing.x;
    if (!row.absent.empty()) taken += ImGui::GetFrameHeight() + style.ItemSpacing.x;
    EXPECT_LE(taken + ImGui::CalcTextSize(present::words_of(row).c_str()).x, room) << row.key;
  }
}

// Fails if theme, size of letters or width of the main panel cannot be chosen, or the next window has others.
TEST_F(WindowLayoutTest, LooksAreRemembered) {
  open(quick_options());
  toggle_header("View");
  choose("theme", "light");
  choose("text size", "80 %");
  turn(3);
  const float before = main_panel()->Size.x;
  const int edge = static_cast<int>(main_panel()->Pos.x + main_panel()->Size.x) + 4;
  drag({edge, 300}, {edge - 40, 300});
  turn(3);
  EXPECT_NEAR(main_panel()->Size.x, before - 40.0f, 6.0f);
  const present::Look chosen = state().look;
  EXPECT_EQ(chosen.theme, present::Theme::light);
  EXPECT_EQ(ImGui::GetStyle().Colors[ImGuiCol_PopupBg].w, 1.0f) << "the text below a menu shows through";
  EXPECT_EQ(chosen.text_scale, 0.8f);
  open(quick_options());
  present::Look remembered = state().look;
  remembered.window = chosen.window;
  EXPECT_EQ(remembered, chosen);
  EXPECT_NEAR(main_panel()->Size.x, before - 40.0f, 6.0f);
}

// Fails if a value cannot be found by its name and changed where it is found, or the sections do not come
// back.
TEST_F(WindowLayoutTest, ValuesAreSearched) {
  open(quick_options());
  press_with_control("f");
  turn(2);
  type("wind speed");
  const scene::Parameter& speed = *scene::find_parameter("wind.speed_mps");
  const Spot slider = find(main_panel(), present::parameter_label(speed), 70);
  drag(slider, {slider.x + 30, slider.y});
  EXPECT_NE(state().scene.wind.wind_speed_mps, quick_options().scene.wind.wind_speed_mps);
  press_with_control("f");
  turn(2);
  press_with_control("a");
  press("BackSpace");
  press("Return");
  toggle_header("Wind");
  find(main_panel(), present::parameter_label(speed), 70);
}

// Fails if a Beaufort force or an hour of the day is not one click and one edit.
TEST_F(WindowLayoutTest, PresetsAreOneClick) {
  open(quick_options());
  const std::string before = edited_text();
  toggle_header("Spectrum");
  click(find(main_panel(), "7##beaufort-7", 242));
  EXPECT_EQ(state().scene.ocean.spectrum.hs_m, 4.0);
  toggle_header("Spectrum");
  toggle_header("Sun");
  click(find(main_panel(), "noon", 155));
  EXPECT_NEAR(state().scene.view.sun_direction.elevation_rad, 1.194, 1e-3);
  undo(2);
  EXPECT_EQ(edited_text(), before);
}

}  // namespace
}  // namespace offing::test
