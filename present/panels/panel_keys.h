#pragma once

#include <deque>

struct GLFWwindow;

namespace offing::present {

/// Keys and letters of a window that no frame has seen yet. ImGui before 1.87 looks at keys once a frame: it
/// misses a key that goes down and up between two frames, and takes letters before keys. So each frame gets
/// the events up to the first key that does more than write a letter. Later versions of ImGui do this
/// themselves. Only one PanelKeys may exist at a time.
class PanelKeys {
 public:
  /// Replaces the window's callbacks of keys and letters, and still calls them, so that ImGui finds none.
  explicit PanelKeys(GLFWwindow* window);
  PanelKeys(const PanelKeys&) = delete;
  PanelKeys& operator=(const PanelKeys&) = delete;
  /// Gives them back. ImGui must have left the window.
  ~PanelKeys();

  /// From here on the window's keys wait; ImGui has its callbacks.
  void listen();
  bool are_waiting() const { return !events_.empty(); }
  /// Passes them to ImGui, before its next frame.
  void pass();

 private:
  /// A key that went down or up, or a letter.
  struct Event {
    bool is_letter = false;
    unsigned letter = 0;
    int key = 0, scancode = 0, action = 0, modifiers = 0;
  };

  static void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void on_letter(GLFWwindow* window, unsigned letter);

  GLFWwindow* window_;
  void (*earlier_on_key_)(GLFWwindow*, int, int, int, int) = nullptr;
  void (*earlier_on_letter_)(GLFWwindow*, unsigned) = nullptr;
  std::deque<Event> events_;
};

}  // namespace offing::present
