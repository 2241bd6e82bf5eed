#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace offing::test {

/// Keyboard and mouse of the display that DISPLAY names, moved through the server's XTEST extension, and what
/// a window manager would do, since there is none: programs cannot tell them from a user's.
class Hands {
 public:
  Hands();
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;
  ~Hands();

  enum class Motion { down, up };
  enum class Button : unsigned { left = 1, middle = 2, right = 3, wheel_up = 4, wheel_down = 5 };

  /// A key by its X name: "space", "F12", "a", "Shift_L".
  void key(std::string_view name, Motion motion);
  void press(std::string_view name);
  /// Types ASCII characters.
  void type(std::string_view text);
  void move_to(int x, int y);
  void button(Button button, Motion motion);
  /// Whether a window has the keyboard.
  bool has_window() const;
  /// Of the window that has the keyboard, UTF-8.
  std::string title() const;
  /// As a window manager closes the window that has the keyboard.
  void close();
  /// All pixels of the screen, four bytes each.
  std::vector<unsigned char> screen() const;
  /// As a window manager minimises and restores the window that has the keyboard.
  void minimise();
  void restore();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace offing::test
