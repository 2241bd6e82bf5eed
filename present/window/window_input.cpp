#include "present/window/window_input.h"

#include <algorithm>
#include <utility>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace offing::present {
namespace {

WindowInput& input_of(GLFWwindow* window) {
  return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

bool panels_want_keys() {
  return ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantTextInput;
}

bool panels_want_mouse() {
  return ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantCaptureMouse;
}

}  // namespace

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, on_key);
  glfwSetScrollCallback(window, on_wheel);
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetDropCallback(window, on_drop);
  glfwSetCursorPosCallback(window, on_move);
  glfwSetCharCallback(window, on_letter);
  glfwSetWindowFocusCallback(window, on_focus);
  glfwSetCursorEnterCallback(window, on_enter);
  glfwSetFramebufferSizeCallback(window, on_size);
  glfwSetWindowRefreshCallback(window, on_damage);
  glfwSetWindowCloseCallback(window, on_close);
}

WindowInput::~WindowInput() {
  glfwSetKeyCallback(window_, nullptr);
  glfwSetScrollCallback(window_, nullptr);
  glfwSetMouseButtonCallback(window_, nullptr);
  glfwSetDropCallback(window_, nullptr);
  glfwSetCursorPosCallback(window_, nullptr);
  glfwSetCharCallback(window_, nullptr);
  glfwSetWindowFocusCallback(window_, nullptr);
  glfwSetCursorEnterCallback(window_, nullptr);
  glfwSetFramebufferSizeCallback(window_, nullptr);
  glfwSetWindowRefreshCallback(window_, nullptr);
  glfwSetWindowCloseCallback(window_, nullptr);
  glfwSetWindowUserPointer(window_, nullptr);
}

void WindowInput::on_key(GLFWwindow* window, int key, int, int action, int modifiers) {
  WindowInput& input = input_of(window);
  input.note_deed();
  if (action == GLFW_RELEASE) input.camera_keys_.erase(key);
  // Keys that are held do not repeat: a slow frame would queue up actions.
  if (action != GLFW_PRESS || panels_want_keys()) return;
  // If Ctrl is released first, the letter that is still down must not move the camera.
  if ((modifiers & GLFW_MOD_CONTROL) == 0) input.camera_keys_.insert(key);
  if (const std::optional<KeyPress> press = press_of(key, modifiers)) {
    input.presses_.push_back(*press);
  }
}

void WindowInput::on_wheel(GLFWwindow* window, double, double y) {
  input_of(window).note_deed();
  if (!panels_want_mouse()) input_of(window).wheel_ += y;
}

void WindowInput::on_button(GLFWwindow* window, int button, int action, int modifiers) {
  WindowInput& input = input_of(window);
  input.note_deed();
  const bool is_press = action == GLFW_PRESS;
  if (is_press && panels_want_mouse()) return;
  if (button == GLFW_MOUSE_BUTTON_MIDDLE && is_press) input.clicks_.push_back(input.pointer());
  if (button != GLFW_MOUSE_BUTTON_LEFT) return;
  input.pointer_events_.push_back({is_press ? PointerEvent::Kind::pressed : PointerEvent::Kind::released,
                                   input.pointer(), (modifiers & GLFW_MOD_SHIFT) != 0});
}

void WindowInput::on_drop(GLFWwindow* window, int count, const char** paths) {
  WindowInput& input = input_of(window);
  input.note_deed();
  input.dropped_files_.insert(input.dropped_files_.end(), paths, paths + count);
}

void WindowInput::on_move(GLFWwindow* window, double, double) {
  WindowInput& input = input_of(window);
  ++input.events_;
  bool is_followed = panels_want_mouse();
  for (const int button : {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_RIGHT})
    is_followed = is_followed || glfwGetMouseButton(window, button) == GLFW_PRESS;
  if (is_followed) ++input.deeds_;
}

void WindowInput::on_letter(GLFWwindow* window, unsigned) {
  input_of(window).note_deed();
}
void WindowInput::on_focus(GLFWwindow* window, int) {
  input_of(window).note_deed();
}
void WindowInput::on_enter(GLFWwindow* window, int) {
  ++input_of(window).events_;
}
void WindowInput::on_size(GLFWwindow* window, int, int) {
  input_of(window).note_deed();
}
void WindowInput::on_damage(GLFWwindow* window) {
  ++input_of(window).events_;
}
void WindowInput::on_close(GLFWwindow* window) {
  input_of(window).note_deed();
}

void WindowInput::note_deed() {
  ++events_;
  ++deeds_;
}

std::vector<std::filesystem::path> WindowInput::take_dropped_files() {
  return std::exchange(dropped_files_, {});
}

std::vector<glm::dvec2> WindowInput::take_clicks() {
  return std::exchange(clicks_, {});
}

std::vector<PointerEvent> WindowInput::take_pointer_events() {
  return std::exchange(pointer_events_, {});
}

glm::dvec2 WindowInput::pointer() const {
  double x = 0.0, y = 0.0;
  int width = 1, height = 1;
  glfwGetCursorPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  return {2.0 * (x + 0.5) / width - 1.0, 1.0 - 2.0 * (y + 0.5) / height};
}

PointerNow WindowInput::pointer_now() const {
  return {pointer(), holds_control()};
}

bool WindowInput::holds_control() const {
  return is_held(GLFW_KEY_LEFT_CONTROL) || is_held(GLFW_KEY_RIGHT_CONTROL);
}

bool WindowInput::is_held(int key) const {
  return glfwGetKey(window_, key) == GLFW_PRESS;
}

std::vector<KeyPress> WindowInput::take_presses() {
  return std::exchange(presses_, {});
}

CameraInput WindowInput::take_camera_input() {
  CameraInput input;
  input.wheel = std::exchange(wheel_, 0.0);
  if (!panels_want_keys() && !holds_control()) {
    const auto axis = [&](int positive, int negative) {
      return static_cast<double>(camera_keys_.count(positive)) -
             static_cast<double>(camera_keys_.count(negative));
    };
    input.move = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S)};
    input.is_fast = is_held(GLFW_KEY_LEFT_SHIFT) || is_held(GLFW_KEY_RIGHT_SHIFT);
    input.is_slow = is_held(GLFW_KEY_LEFT_ALT) || is_held(GLFW_KEY_RIGHT_ALT);
  }
  double x = 0.0, y = 0.0;
  glfwGetCursorPos(window_, &x, &y);
  const bool is_down = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS ||
                       glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
  // A drag that began on a panel stays the panel's.
  is_camera_held_ = is_camera_held_ && is_down;
  if (is_camera_held_) is_dragging_ = false;
  if (is_down && is_dragging_) {
    int width = 1, height = 1;
    glfwGetWindowSize(window_, &width, &height);
    input.turn = glm::dvec2(x - drag_x_, y - drag_y_) / static_cast<double>(std::max(1, height));
  }
  is_dragging_ = is_down && !is_camera_held_ && (is_dragging_ || !panels_want_mouse());
  drag_x_ = x;
  drag_y_ = y;
  return input;
}

}  // namespace offing::present
