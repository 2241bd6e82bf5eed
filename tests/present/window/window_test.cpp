#include "tests/present/window/window_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
// What ImGui keeps of windows and items, to find them as a user does with his eyes.
#include <imgui_internal.h>

#include "host/base/host_memory.h"
#include "host/scene/file/scene_writer.h"
#include "present/panels/imgui_versions.h"

namespace offing::test {
namespace {

// Room for the panels and a little more: frames are quick to draw.
constexpr int window_width = 480, window_height = 1000;
constexpr int timeline_height = 140;

unsigned id_of(ImGuiWindow* window, const std::string& label, std::optional<int> element) {
  return element ? ImHashStr(label.c_str(), 0, window->GetID(*element)) : window->GetID(label.c_str());
}

}  // namespace

void WindowTest::SetUp() {
  unsetenv("WAYLAND_DISPLAY");
  std::string reason;
  display_ = VirtualDisplay::start(reason, display_size());
  if (!display_) GTEST_SKIP() << reason;
  hands_ = std::make_unique<Hands>();
  std::filesystem::current_path(folder_.path());  // pictures and scenes are written here
  // What windows remember is none of other windows.
  setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
}

void WindowTest::TearDown() {
  viewer_.reset();
  hands_.reset();
  display_.reset();
  std::filesystem::current_path("/");
}

present::ViewOptions WindowTest::quick_options() {
  present::ViewOptions options;
  options.scene.ocean.parameters.size = 32;
  options.scene.view.camera.pitch_rad = 1.2;
  options.time_s = 2.0;
  options.starts_paused = true;
  options.kept_hz = 0.0;
  options.render_scale = 0.3;
  options.detail = present::Detail::low;
  options.verbosity = Verbosity::quiet;
  return options;
}

void WindowTest::open(const present::ViewOptions& options) {
  viewer_.reset();
  keep_large_arrays_apart();  // as show_window() does
  viewer_ = std::make_unique<present::Viewer>(options, cancel_);
  glfwSetWindowSize(viewer_->window(), window_width, window_height);
  constexpr double longest_s = 10.0;
  const double start_s = glfwGetTime();
  do {
    ASSERT_LT(glfwGetTime() - start_s, longest_s) << "the window does not get the keyboard";
    glfwWaitEventsTimeout(0.05);
  } while (glfwGetWindowAttrib(viewer_->window(), GLFW_FOCUSED) == GLFW_FALSE);
  hands_->move_to(window_width - 20, window_height - timeline_height - 20);
  turn(3);  // panels have their sizes
  ASSERT_TRUE(state().clock.is_paused());
  ASSERT_EQ(state().clock.time_s(), options.time_s);
}

void WindowTest::turn(int count) {
  for (int i = 0; i < count; ++i) viewer_->turn();
}

void WindowTest::settle() {
  const ImVec2 at = ImGui::GetIO().MousePos;
  for (int i = 0; i < 8; ++i) {
    hands_->move_to(static_cast<int>(at.x) + i % 2, static_cast<int>(at.y));
    turn();
  }
}

void WindowTest::press(const char* key) {
  ++steps_;
  hands_->key(key, Hands::Motion::down);
  turn();
  hands_->key(key, Hands::Motion::up);
  turn();
}

void WindowTest::press_with_control(const char* key) {
  hands_->key("Control_L", Hands::Motion::down);
  turn();
  press(key);
  hands_->key("Control_L", Hands::Motion::up);
  turn();
}

void WindowTest::click(Spot spot) {
  ++steps_;
  hands_->move_to(spot.x, spot.y);
  turn();
  hands_->button(Hands::Button::left, Hands::Motion::down);
  turn();
  hands_->button(Hands::Button::left, Hands::Motion::up);
  turn(2);
}

void WindowTest::drag(Spot from, Spot to) {
  ++steps_;
  hands_->move_to(from.x, from.y);
  turn();
  // Where frames are quick, a press where the last click chose from a list is a double click, which types.
  const ImGuiIO& io = ImGui::GetIO();
  const double end_s = glfwGetTime() + double{io.MouseDoubleClickTime};
  while (glfwGetTime() < end_s && ImGui::GetTime() - io.MouseClickedTime[0] < double{io.MouseDoubleClickTime})
    turn();
  hands_->button(Hands::Button::left, Hands::Motion::down);
  turn();
  hands_->move_to(to.x, to.y);
  turn();
  hands_->button(Hands::Button::left, Hands::Motion::up);
  turn(2);
}

WindowTest::Spot WindowTest::spot(glm::dvec2 px) {
  return {static_cast<int>(std::lround(px.x)), static_cast<int>(std::lround(px.y))};
}

void WindowTest::pull(glm::dvec2 from_px, glm::dvec2 to_px, int frames_held) {
  ++steps_;
  hands_->move_to(spot(from_px).x, spot(from_px).y);
  turn();
  hands_->button(Hands::Button::left, Hands::Motion::down);
  turn();
  for (int step = 1; step <= 4; ++step) {
    const Spot at = spot(from_px + 0.25 * step * (to_px - from_px));
    hands_->move_to(at.x, at.y);
    turn();
  }
  turn(frames_held);
  hands_->button(Hands::Button::left, Hands::Motion::up);
  turn(2);
}

void WindowTest::type(const std::string& text) {
  ++steps_;
  hands_->type(text);
  do turn();
  while (present::has_waiting_input());
}

void WindowTest::enter(Spot spot, const std::string& text) {
  click(spot);
  press_with_control("a");
  type(text);
  press("Return");
}

void WindowTest::enter_into_slider(Spot spot, const std::string& text) {
  hands_->key("Control_L", Hands::Motion::down);
  turn();
  click(spot);
  hands_->key("Control_L", Hands::Motion::up);
  turn();
  type(text);
  press("Return");
  turn(2);
}

std::string WindowTest::edited_text() const {
  scene::Scene scene = state().scene;
  scene.view.camera = {};
  scene.view.mode = {};
  return scene::scene_text(scene, "");
}

void WindowTest::undo(int count) {
  hands_->key("Control_L", Hands::Motion::down);
  turn();
  for (int i = 0; i < count; ++i) press("z");
  hands_->key("Control_L", Hands::Motion::up);
  turn();
}

void WindowTest::redo(int count) {
  hands_->key("Shift_L", Hands::Motion::down);
  turn();
  undo(count);
  hands_->key("Shift_L", Hands::Motion::up);
  turn();
}

void WindowTest::save_as(const std::string& name) {
  hands_->key("Shift_L", Hands::Motion::down);
  turn();
  press_with_control("s");
  hands_->key("Shift_L", Hands::Motion::up);
  turn(3);
  type(name);
  press("Return");
  turn(3);
}

void WindowTest::drop(const std::vector<std::filesystem::path>& files) {
  const GLFWdropfun told = glfwSetDropCallback(viewer_->window(), nullptr);
  glfwSetDropCallback(viewer_->window(), told);
  std::vector<const char*> names;
  for (const std::filesystem::path& file : files) names.push_back(file.c_str());
  told(viewer_->window(), static_cast<int>(names.size()), names.data());
  turn(static_cast<int>(2 * names.size()));
}

void WindowTest::look_at_sea() {
  for (int i = 0; i < 20 && state().camera.camera().pitch_rad > -0.2; ++i) {
    drag({window_width - 60, 100}, {window_width - 60, window_height - timeline_height});
  }
  ASSERT_LT(state().camera.camera().pitch_rad, -0.1) << "the picture does not follow the mouse";
}

std::vector<unsigned char> WindowTest::picture() {
  constexpr double longest_s = 20.0;
  const double end_s = glfwGetTime() + longest_s;
  while (state().clock.is_paused() && !viewer_->is_sharp() && glfwGetTime() < end_s) turn();
  return viewer_->sea().frame().screen().read_bytes();
}

int WindowTest::width() const {
  return viewer_->sea().frame().screen().width();
}

int WindowTest::height() const {
  return viewer_->sea().frame().screen().height();
}

ImGuiWindow* WindowTest::main_panel() {
  return ImGui::FindWindowByName("Offing");
}

ImGuiWindow* WindowTest::values() {
  return ImGui::FindWindowByName("Values");
}

ImGuiWindow* WindowTest::timeline() {
  return ImGui::FindWindowByName("Timeline");
}

WindowTest::Spot WindowTest::on_timeline(double time_s) const {
  const ImGuiWindow& window = *timeline();
  const float above_end_px = ImGui::GetStyle().WindowPadding.y + ImGui::GetFontSize();
  return {static_cast<int>(std::lround(state().timeline.scale.x_px(time_s))),
          static_cast<int>(window.Pos.y + window.Size.y - above_end_px)};
}

ImGuiWindow* WindowTest::open_list() {
  return ImGui::FindWindowByName("##Combo_00");
}

ImGuiWindow* WindowTest::open_menu() {
  const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
  return popups.empty() ? nullptr : popups.back().Window;
}

bool WindowTest::is_hovered(unsigned id) const {
  return ImGui::GetCurrentContext()->HoveredId == id;
}

WindowTest::Spot WindowTest::find(ImGuiWindow* window, const std::string& label, int x_px,
                                  std::optional<int> element) {
  if (window == nullptr) {
    ADD_FAILURE() << label << ": its window is not open";
    return {};
  }
  return find_item(window, label, id_of(window, label, element), x_px);
}

WindowTest::Spot WindowTest::find_triple(ImGuiWindow* window, const std::string& label,
                                         std::optional<int> element) {
  // As ImGui::DragScalarN() names its fields.
  constexpr int first = 0;
  const unsigned id = ImHashStr("", 0, ImHashData(&first, sizeof(first), id_of(window, label, element)));
  return find_item(window, label, id, 30);
}

std::optional<WindowTest::Spot> WindowTest::spot_of(ImGuiWindow* window, unsigned id, int x_px) {
  constexpr int step_px = 12;  // less than the lowest button is high
  const int x = static_cast<int>(window->Pos.x) + x_px;
  for (int screen = 0; screen < 10; ++screen) {
    const int top = static_cast<int>(window->InnerRect.Min.y),
              end = static_cast<int>(window->InnerRect.Max.y);
    // From the last item on: most lie in order.
    const int count = (end - top) / step_px, first = std::clamp((last_y_ - top) / step_px, 0, count - 1);
    for (int i = 0; i < count; ++i) {
      const int y = top + 2 + (first + i) % count * step_px;
      hands_->move_to(x, y);
      turn();
      if (!is_hovered(id)) continue;
      last_y_ = y;
      return Spot{x, y};
    }
    if (window->ScrollMax.y <= 0.0f) break;
    // Down to the end, then once more from the top.
    const bool is_at_end = window->Scroll.y >= window->ScrollMax.y;
    for (int notch = 0; notch < (is_at_end ? 50 : 3); ++notch) {
      const Hands::Button wheel = is_at_end ? Hands::Button::wheel_up : Hands::Button::wheel_down;
      hands_->button(wheel, Hands::Motion::down);
      hands_->button(wheel, Hands::Motion::up);
    }
    turn(2);
  }
  return {};
}

WindowTest::Spot WindowTest::find_item(ImGuiWindow* window, const std::string& label, unsigned id, int x_px) {
  if (const std::optional<Spot> spot = spot_of(window, id, x_px)) return *spot;
  // Buttons beside each other are elsewhere with letters of another width.
  for (int x = 14; x < static_cast<int>(window->Size.x); x += 14) {
    if (const std::optional<Spot> spot = spot_of(window, id, x)) return *spot;
  }
  ADD_FAILURE() << label << ": the mouse finds no such item in " << window->Name;
  return {};
}

void WindowTest::wait_for_clouds() {
  constexpr double longest_s = 60.0;
  const double end_s = glfwGetTime() + longest_s;
  while (viewer_->sea().is_making()) {
    ASSERT_LT(glfwGetTime(), end_s) << "the clouds are never made";
    turn();
  }
  turn(2);
}

void WindowTest::choose(const std::string& combo, const std::string& name, std::optional<int> element) {
  click(find(values(), combo, 60, element));
  click(find(open_list(), name, 20));
}

}  // namespace offing::test
