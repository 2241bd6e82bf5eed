// The window on older versions of OpenGL, as Mesa's overrides give them.
#include <cstdlib>

#include <epoxy/gl.h>

#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

class WindowContextTest : public WindowTest {
 protected:
  void TearDown() override {
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_EXTENSION_OVERRIDE");
    WindowTest::TearDown();
  }
};

// Fails if a context of a later version than there is is asked for in vain, or the sea looks otherwise there:
// mean difference below 1/255.
TEST_F(WindowContextTest, LooksTheSameOnOlderOpenGl) {
  const auto sea = [&] {
    open(quick_options());
    look_at_sea();
    turn(2);
    return picture();
  };
  const std::vector<unsigned char> expected = sea();
  for (const char* version : {"4.1", "3.3"}) {
    viewer_.reset();
    setenv("MESA_GL_VERSION_OVERRIDE", version, 1);
    setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_buffer_storage -GL_ARB_clip_control", 1);
    const std::vector<unsigned char> found = sea();
    const std::string given(reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    if (!given.starts_with(version)) GTEST_SKIP() << "this driver does not take the override: " << given;
    ASSERT_EQ(found.size(), expected.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) sum += std::abs(found[i] - expected[i]);
    EXPECT_LT(sum / static_cast<double>(found.size()), 1.0) << version;
  }
}

}  // namespace
}  // namespace offing::test
