// F5: kernels and shaders that are edited while the window shows them.
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "present/view_options.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

class WindowReloadTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    const std::filesystem::path sources = OFFING_SOURCES;
    const auto all = std::filesystem::copy_options::recursive;
    std::filesystem::copy(sources / "kernels", folder_.path() / "kernels", all);
    std::filesystem::create_directory(folder_.path() / "present");
    std::filesystem::copy(sources / "present/passes", folder_.path() / "present/passes", all);
    present::use_sources(folder_.path());
    open(quick_options());
    look_at_sea();
    turn(2);
  }
  void TearDown() override {
    unsetenv("OFFING_KERNEL_PATH");
    unsetenv("OFFING_SHADER_PATH");
    WindowTest::TearDown();
  }

  /// Breaks a file, presses F5, fixes the file and presses it again.
  void expect_survives(const std::string& file, const std::string& fault) {
    const std::vector<unsigned char> before = picture();
    const std::filesystem::path path = folder_.path() / file;
    std::ifstream stream(path);
    const std::string good(std::istreambuf_iterator<char>(stream), {});
    std::ofstream(path) << "this is a fault;\n" << good;
    press("F5");
    EXPECT_NE(message().find(fault), std::string::npos) << message();
    EXPECT_TRUE(state().message.is_fault);
    turn(2);
    EXPECT_TRUE(picture() == before) << "the last good one is not drawn";
    std::ofstream(path) << good;
    press("F5");
    EXPECT_FALSE(state().message.is_fault) << message();
    turn(2);
    EXPECT_TRUE(picture() == before);
  }
};

// Fails if a kernel that does not compile ends the window or stops the sea, or the compiler is not heard.
TEST_F(WindowReloadTest, KeepsTheLastGoodKernel) {
  expect_survives("kernels/ocean/foam_coverage.cl", "foam_coverage.cl:1");
}

TEST_F(WindowReloadTest, KeepsTheLastGoodShader) {
  expect_survives("present/passes/water/water_light.glsl", "water_light.glsl:1");
}

// Fails if F5 does not read the files: the water is drawn in a colour that was not there.
TEST_F(WindowReloadTest, ShowsWhatWasEdited) {
  const std::filesystem::path path = folder_.path() / "present/passes/tone.frag";
  std::ofstream(path) << "out vec4 colour;\nvoid main() { colour = vec4(1.0, 0.0, 0.0, 1.0); }\n";
  press("F5");
  EXPECT_FALSE(state().message.is_fault) << message();
  turn(2);
  const std::vector<unsigned char> red = picture();
  EXPECT_EQ(red[0], 255);
  EXPECT_EQ(red[1], 0);
}

}  // namespace
}  // namespace offing::test
