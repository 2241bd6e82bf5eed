#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <vector>

#include <glm/vec2.hpp>

#include "present/window/free_camera.h"
#include "present/window/key_bindings.h"

struct GLFWwindow;

namespace offing::present {

/// What the left button did, and where, in clip coordinates of the window.
struct PointerEvent {
  enum class Kind { pressed, released };
  Kind kind = Kind::pressed;
  glm::dvec2 clip{0.0};
  bool is_beside = false;  ///< with Shift: what was picked stays picked
};

/// Where the mouse is, in clip coordinates of the window.
struct PointerNow {
  glm::dvec2 clip{0.0};
  bool is_snapping = false;  ///< Ctrl is held
};

/// Keys and mouse of a window, as far as panels leave them to the view. Made before ImGui, which passes
/// events on.
class WindowInput {
 public:
  /// The window's user pointer is this object's from here on.
  explicit WindowInput(GLFWwindow* window);
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;
  ~WindowInput();

  /// What was asked for since the last call, in order.
  std::vector<KeyPress> take_presses();
  CameraInput take_camera_input();
  /// Where the middle button went down since the last call, in clip coordinates of the window.
  std::vector<glm::dvec2> take_clicks();
  /// What the left button did since the last call, in order; presses on panels are the panels'.
  std::vector<PointerEvent> take_pointer_events();
  /// Files that were dropped on the window since the last call, in order.
  std::vector<std::filesystem::path> take_dropped_files();
  /// The mouse does not turn the camera from here on until its buttons are up.
  void hold_camera() { is_camera_held_ = true; }
  /// Where the mouse is, in clip coordinates of the window.
  glm::dvec2 pointer() const;
  PointerNow pointer_now() const;
  /// Counts all that came: keys, mouse, and what the window's system wants.
  std::uint64_t events() const { return events_; }
  /// The same without moves of a mouse that nothing follows.
  std::uint64_t deeds() const { return deeds_; }

 private:
  static void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void on_wheel(GLFWwindow* window, double x, double y);
  static void on_button(GLFWwindow* window, int button, int action, int modifiers);
  static void on_drop(GLFWwindow* window, int count, const char** paths);
  static void on_move(GLFWwindow* window, double x, double y);
  static void on_letter(GLFWwindow* window, unsigned letter);
  static void on_focus(GLFWwindow* window, int has_focus);
  static void on_enter(GLFWwindow* window, int has_entered);
  static void on_size(GLFWwindow* window, int width, int height);
  static void on_damage(GLFWwindow* window);
  static void on_close(GLFWwindow* window);
  void note_deed();

  bool is_held(int key) const;
  bool holds_control() const;

  GLFWwindow* window_;
  std::vector<KeyPress> presses_;
  std::vector<glm::dvec2> clicks_;
  std::vector<PointerEvent> pointer_events_;
  std::vector<std::filesystem::path> dropped_files_;
  std::set<int> camera_keys_;  // that are down, and went down without Ctrl
  std::uint64_t events_ = 0, deeds_ = 0;
  double wheel_ = 0.0;
  bool is_dragging_ = false, is_camera_held_ = false;
  double drag_x_ = 0.0, drag_y_ = 0.0;  // where the mouse was
};

}  // namespace offing::present
