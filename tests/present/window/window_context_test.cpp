// The window on older versions of OpenGL, as Mesa's overrides give them.
#include <cstdlib>
#include <vector>

#include <epoxy/gl.h>

#include "host/scene/file/scene_file.h"
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

/// All that is drawn by passes of its own: water with a wake and a hull, ground, clouds, meshes, highlights.
constexpr const char* all_passes = R"(version = 1
[camera]
y_m = 5
z_m = 14
pitch_deg = -4
[ocean]
size = 32
cascade_count = 1
[[ocean.wake]]
centre = "place"
length_m = 24
cells = 32
history_s = 1
[terrain]
posts = 65
side_m = 400
mean_m = -12
relief_m = 40
origin_z_m = -500
[[mesh]]
name = "hull"
shape = "ship"
size_m = 6
detail = 1
[[mesh]]
shape = "sphere"
size_m = 1.5
detail = 2
y_m = 7
[[mesh.highlight]]
[[light]]
kind = "place"
y_m = 7
z_m = 4
[[body]]
mesh = "hull"
draught_m = 0.4
[clouds]
quality = 0.1
[[cloud]]
y_m = 300
z_m = -1200
)";

// Fails if a context of a later version than there is is asked for in vain, or a picture looks otherwise
// there, of a sea and of all that is drawn: mean difference below 1/255.
TEST_F(WindowContextTest, LooksTheSameOnOlderOpenGl) {
  const auto pictures = [&] {
    std::vector<std::vector<unsigned char>> found;
    open(quick_options());
    look_at_sea();
    turn(2);
    found.push_back(picture());
    present::ViewOptions options = quick_options();
    options.scene = scene::parse_scene(all_passes, "all.toml", "");
    open(options);
    wait_for_clouds();
    found.push_back(picture());
    return found;
  };
  const auto expected = pictures();
  for (const char* version : {"4.1", "3.3"}) {
    viewer_.reset();
    setenv("MESA_GL_VERSION_OVERRIDE", version, 1);
    setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_buffer_storage -GL_ARB_clip_control", 1);
    const auto found = pictures();
    const std::string given(reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    if (!given.starts_with(version)) GTEST_SKIP() << "this driver does not take the override: " << given;
    for (std::size_t number = 0; number < expected.size(); ++number) {
      ASSERT_EQ(found[number].size(), expected[number].size());
      double sum = 0.0;
      for (std::size_t i = 0; i < found[number].size(); ++i)
        sum += std::abs(found[number][i] - expected[number][i]);
      EXPECT_LT(sum / static_cast<double>(found[number].size()), 1.0) << version << ", picture " << number;
    }
  }
}

}  // namespace
}  // namespace offing::test
