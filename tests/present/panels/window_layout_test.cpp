// Where panels lie in windows of usual sizes, how they look, and what windows remember of that.
#include <array>
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
    hands_->move_to(60, 14);  // on a title, which has no tooltip
    turn(2);
    settle();
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
    EXPECT_EQ(all.size(), 7u) << "main panel, values, cloud editor or keys, map, legend, message, timeline";
    for (const ImGuiWindow* one : all) {
      EXPECT_GE(one->Pos.x, 0.0f) << one->Name;
      EXPECT_GE(one->Pos.y, 0.0f) << one->Name;
      EXPECT_LE(one->Pos.x + one->Size.x, static_cast<float>(width)) << one->Name;
      EXPECT_LE(one->Pos.y + one->Size.y, static_cast<float>(height)) << one->Name;
      for (const ImGuiWindow* other : all) {
        if (other == one) break;
        if (lies_over_for_a_while(*one, *other) || lies_over_for_a_while(*other, *one)) continue;
        EXPECT_FALSE(one->Rect().Overlaps(other->Rect())) << one->Name << " and " << other->Name;
      }
    }
  }
  /// Where the picture is narrow, messages lie over what is right of it until they go.
  static bool lies_over_for_a_while(const ImGuiWindow& message, const ImGuiWindow& other) {
    const float room_px = other.Pos.x - (values()->Pos.x + values()->Size.x);
    return std::string_view(message.Name) == "Message" && room_px > 0.0f &&
           room_px < 16.0f * ImGui::GetFontSize();
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

// Fails if a message moves a panel or covers the values; if news stay, or a fault goes before it is clicked
// on.
TEST_F(WindowLayoutTest, MessagesLieOverThePicture) {
  open(full_options());
  resize(900, 500);
  const auto shape_of = [](const ImGuiWindow* window) {
    return std::array{window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
  };
  const auto before = shape_of(values());
  press("c");
  settle();
  const ImGuiWindow* box = ImGui::FindWindowByName("Message");
  ASSERT_NE(box, nullptr);
  ASSERT_TRUE(box->WasActive);
  EXPECT_EQ(shape_of(values()), before);
  for (const ImGuiWindow* other : {main_panel(), values(), timeline()})
    EXPECT_FALSE(box->Rect().Overlaps(other->Rect())) << other->Name;
  constexpr double longest_s = 30.0;
  double end_s = glfwGetTime() + longest_s;
  while (!message().empty() && glfwGetTime() < end_s) turn();
  EXPECT_EQ(message(), "");
  drop({"nowhere.tif"});
  ASSERT_TRUE(state().message.is_fault);
  const std::string fault = message();
  constexpr double news_stay_s = 4.0, letter_s = 0.06;  // as the window has it
  end_s = glfwGetTime() + news_stay_s + letter_s * static_cast<double>(fault.size()) + 1.0;
  while (glfwGetTime() < end_s) turn();
  EXPECT_EQ(message(), fault);
  turn(3);
  click(spot({box->Pos.x + 0.5f * box->Size.x, box->Pos.y + 0.5f * box->Size.y}));
  EXPECT_EQ(message(), "");
}

// Fails if a tooltip covers a part of its panel where there is room beside it, its own item where there is
// none, or leaves the window.
TEST_F(WindowLayoutTest, TooltipsCoverNothing) {
  open(full_options());
  toggle_header("Wind");
  const scene::Parameter& speed = *scene::find_parameter("wind.speed_mps");
  for (const int width : {480, 900, 1280}) {
    SCOPED_TRACE(width);
    resize(width, 700);
    find(values(), present::parameter_label(speed), 70);
    turn(4);
    const ImGuiWindow* help = ImGui::FindWindowByName("##Tooltip_00");
    ASSERT_TRUE(help != nullptr && help->Active && !help->Hidden);
    EXPECT_GE(help->Pos.x, 0.0f);
    EXPECT_GE(help->Pos.y, 0.0f);
    EXPECT_LE(help->Pos.x + help->Size.x, static_cast<float>(width));
    EXPECT_LE(help->Pos.y + help->Size.y, 700.0f);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    EXPECT_FALSE(help->Rect().Contains(mouse));
    const bool has_room_beside = width > 600;
    EXPECT_FALSE(has_room_beside && help->Rect().Overlaps(values()->Rect()));
  }
}

// Fails if values that scroll take the list, the search or the buttons along, or have hardly any room in a
// low window.
TEST_F(WindowLayoutTest, ValuesScrollAlone) {
  open(full_options());
  resize(900, 500);
  const Spot add = find(main_panel(), "add##objects", 20);
  toggle_header("Wind");
  const float room_px = values()->InnerRect.GetHeight();
  EXPECT_GT(room_px, 5.0f * ImGui::GetFrameHeightWithSpacing());
  hands_->move_to(200, static_cast<int>(values()->Pos.y) + 40);
  turn();
  for (int i = 0; i < 40; ++i) {
    hands_->button(Hands::Button::wheel_down, Hands::Motion::down);
    hands_->button(Hands::Button::wheel_down, Hands::Motion::up);
  }
  turn(3);
  EXPECT_GT(values()->Scroll.y, 100.0f);
  EXPECT_EQ(main_panel()->ScrollMax.y, 0.0f);
  const Spot same = find(main_panel(), "add##objects", 20);
  EXPECT_EQ(same.y, add.y);
}

// Fails if the name of a value is cut off at the panel's edge, or at its scrollbar.
TEST_F(WindowLayoutTest, NamesOfValuesFit) {
  open(quick_options());
  ASSERT_FALSE(values()->ScrollbarY);
  const float room = values()->WorkRect.GetWidth() - ImGui::GetStyle().ScrollbarSize;
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
  const Spot slider = find(values(), present::parameter_label(speed), 70);
  drag(slider, {slider.x + 30, slider.y});
  EXPECT_NE(state().scene.wind.wind_speed_mps, quick_options().scene.wind.wind_speed_mps);
  press_with_control("f");
  turn(2);
  press_with_control("a");
  press("BackSpace");
  press("Return");
  toggle_header("Wind");
  find(values(), present::parameter_label(speed), 70);
}

// Fails if a Beaufort force or an hour of the day is not one click and one edit.
TEST_F(WindowLayoutTest, PresetsAreOneClick) {
  open(quick_options());
  const std::string before = edited_text();
  toggle_header("Spectrum");
  click(find(values(), "7##beaufort-7", 242));
  EXPECT_EQ(state().scene.ocean.spectrum.hs_m, 4.0);
  toggle_header("Spectrum");
  toggle_header("Sun");
  click(find(values(), "noon", 155));
  EXPECT_NEAR(state().scene.view.sun_direction.elevation_rad, 1.194, 1e-3);
  undo(2);
  EXPECT_EQ(edited_text(), before);
}

}  // namespace
}  // namespace offing::test
