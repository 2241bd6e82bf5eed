// The window in every size, minimised, and without a display server.
#include <cstdlib>
#include <memory>
#include <utility>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "host/base/error.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

class WindowSizeTest : public WindowTest {
 protected:
  void resize(int new_width, int new_height) {
    glfwSetWindowSize(viewer_->window(), new_width, new_height);
    turn(3);
  }
  void expect_context_lives() const {
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_NE(glfwGetCurrentContext(), nullptr);
  }
};

// Fails if a window of one pixel, or one much wider than high, loses the context or the picture.
TEST_F(WindowSizeTest, OnePixelAndBack) {
  open(quick_options());
  look_at_sea();
  turn(2);
  const std::vector<unsigned char> before = picture();
  int usual_width = 0, usual_height = 0;
  glfwGetWindowSize(viewer_->window(), &usual_width, &usual_height);
  for (const Spot size : {Spot{1, 1}, Spot{1200, 2}, Spot{2, 900}, Spot{1, 1}}) {
    resize(size.x, size.y);
    EXPECT_GE(width(), 1);
    EXPECT_LE(width(), size.x);
    EXPECT_LE(height(), size.y);
    expect_context_lives();
  }
  resize(usual_width, usual_height);
  EXPECT_TRUE(picture() == before);
}

// Fails if a minimised window goes on drawing, or does not come back as it was.
TEST_F(WindowSizeTest, MinimisedAndBack) {
  open(quick_options());
  look_at_sea();
  turn(2);
  const std::vector<unsigned char> before = picture();
  press("space");
  hands_->minimise();
  turn(3);
  EXPECT_EQ(glfwGetWindowAttrib(viewer_->window(), GLFW_ICONIFIED), GLFW_TRUE);
  expect_context_lives();
  hands_->restore();
  turn(3);
  EXPECT_EQ(glfwGetWindowAttrib(viewer_->window(), GLFW_ICONIFIED), GLFW_FALSE);
  expect_context_lives();
  EXPECT_FALSE(picture() == before) << "time ran on";
}

// Fails if a window does not have the size that the last one was left in, one of --size is remembered, or the
// scale of the panels is not the one that is asked for.
TEST_F(WindowSizeTest, SizesAreRemembered) {
  open(quick_options());
  resize(700, 501);
  viewer_.reset();
  present::ViewOptions options = quick_options();
  options.size = present::ImageSize{333, 222};
  options.ui_scale = 1.5;
  const auto size = [&] {
    Spot found;
    glfwGetWindowSize(viewer_->window(), &found.x, &found.y);
    return std::pair(found.x, found.y);
  };
  viewer_ = std::make_unique<present::Viewer>(options, cancel_);
  EXPECT_EQ(size(), std::pair(333, 222));
  turn(2);
  EXPECT_EQ(ImGui::GetFontSize(), 24.0f);
  viewer_.reset();
  viewer_ = std::make_unique<present::Viewer>(quick_options(), cancel_);
  EXPECT_EQ(size(), std::pair(700, 501));
}

// Fails if a missing display server is told otherwise than by one line, a fix and the exit code 3.
TEST(NoDisplayTest, IsReportedWithItsHint) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  try {
    const CancelToken cancel;
    const present::Viewer viewer(present::ViewOptions{}, cancel);
    FAIL() << "a window without a display";
  } catch (const Error& error) {
    EXPECT_EQ(exit_code(error.kind()), 3);
    const std::string what = error.what();
    EXPECT_NE(what.find("display"), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_NE(error.hint().find("--headless"), std::string::npos) << error.hint();
  }
}

}  // namespace
}  // namespace offing::test
