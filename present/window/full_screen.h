#pragma once

struct GLFWwindow;

namespace offing::present {

/// Takes a window to the whole screen and back to its place.
class FullScreen {
 public:
  void toggle(GLFWwindow* window);

 private:
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;  // of the window before
};

}  // namespace offing::present
