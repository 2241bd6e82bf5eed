#include "present/gl/gl_context.h"

#include <cstdlib>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

using GlContextTest = test::GlTest;

// Fails if headless needs a display server: none is named while the context is made.
TEST(GlContextWithoutDisplayTest, NeedsNoDisplayServer) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  try {
    const GlContext context = GlContext::headless();
    EXPECT_EQ(context.window_handle(), nullptr);
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    EXPECT_FALSE(error.hint().empty());
    GTEST_SKIP() << "no OpenGL here: " << error.what();
  }
}

// Fails if the capabilities are not those of the context that is current.
TEST_F(GlContextTest, TellsWhatItCanDo) {
  const GlCapabilities& found = context_->capabilities();
  EXPECT_GE(found.major * 10 + found.minor, 33);
  EXPECT_FALSE(found.renderer.empty());
  EXPECT_GE(found.largest_anisotropy, 1.0f);
  EXPECT_TRUE(found.platform.starts_with("EGL")) << found.platform;
}

// Fails if a second context cannot follow the first, or leaves it current after its end.
TEST_F(GlContextTest, FollowsAnother) {
  context_.reset();
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  context_.emplace(GlContext::headless());
  EXPECT_FALSE(context_->capabilities().version.empty());
}

// Fails if an error of OpenGL goes unnoticed, or is reported twice.
TEST_F(GlContextTest, ReportsErrors) {
  glEnable(0xdead);
  EXPECT_THROW(
      {
        try {
          require_no_gl_error("the test's own fault");
        } catch (const Error& error) {
          EXPECT_EQ(error.kind(), ErrorKind::device);
          EXPECT_NE(std::string(error.what()).find("the test's own fault"), std::string::npos);
          throw;
        }
      },
      Error);
  EXPECT_NO_THROW(require_no_gl_error("afterwards"));
}

// Fails if a window is promised where no display server can be, or the error does not say how to go on.
TEST(GlContextWithoutDisplayTest, RefusesAWindowWithoutADisplayServer) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  try {
    GlContext::window({});
    FAIL() << "a window without a display server";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    EXPECT_NE(error.hint().find("--headless"), std::string::npos);
  }
}

}  // namespace
}  // namespace offing::present
