#include "present/panels/panel_keys.h"

#include <set>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
// The order matters: the backend builds on imgui.h.
#include <backends/imgui_impl_glfw.h>

namespace offing::present {
namespace {

PanelKeys* listening = nullptr;

bool does_more_than_write(int key, int modifiers) {
  if (key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER) return false;
  if ((modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return true;
  const bool is_of_pad = key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL && key != GLFW_KEY_KP_ENTER;
  return key >= GLFW_KEY_ESCAPE && !is_of_pad;
}

}  // namespace

PanelKeys::PanelKeys(GLFWwindow* window)
    : window_(window),
      earlier_on_key_(glfwSetKeyCallback(window, nullptr)),
      earlier_on_letter_(glfwSetCharCallback(window, nullptr)) {}

PanelKeys::~PanelKeys() {
  if (listening == this) listening = nullptr;
  glfwSetKeyCallback(window_, earlier_on_key_);
  glfwSetCharCallback(window_, earlier_on_letter_);
}

void PanelKeys::listen() {
  listening = this;
  glfwSetKeyCallback(window_, on_key);
  glfwSetCharCallback(window_, on_letter);
}

void PanelKeys::on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
  if (listening->earlier_on_key_ != nullptr)
    listening->earlier_on_key_(window, key, scancode, action, modifiers);
  // ImGui repeats keys that are held.
  if (action == GLFW_REPEAT) return;
  listening->events_.push_back({.key = key, .scancode = scancode, .action = action, .modifiers = modifiers});
}

void PanelKeys::on_letter(GLFWwindow* window, unsigned letter) {
  if (listening->earlier_on_letter_ != nullptr) listening->earlier_on_letter_(window, letter);
  listening->events_.push_back({.is_letter = true, .letter = letter});
}

void PanelKeys::pass() {
  std::set<int> released;
  bool is_last = false;
  while (!events_.empty() && !is_last) {
    const Event event = events_.front();
    const bool is_press = !event.is_letter && event.action == GLFW_PRESS;
    // A frame would see one that was down before, and stays so.
    if (is_press && released.contains(event.key)) return;
    events_.pop_front();
    if (event.is_letter) {
      ImGui_ImplGlfw_CharCallback(window_, event.letter);
      continue;
    }
    ImGui_ImplGlfw_KeyCallback(window_, event.key, event.scancode, event.action, event.modifiers);
    if (!is_press) released.insert(event.key);
    is_last = is_press && does_more_than_write(event.key, event.modifiers);
  }
}

}  // namespace offing::present
