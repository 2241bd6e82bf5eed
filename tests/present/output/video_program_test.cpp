// offing-view --video, with a program that stands in for ffmpeg.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/io/png_image.h"
#include "tests/cli/offing_program.h"
#include "tests/present/output/stand_in_ffmpeg.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class VideoProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    std::ofstream(path("sea.toml")) << "version = 1\n[time]\nfps = 10\nend_s = 0.3\n[ocean]\nsize = 32\n";
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> all{path("sea.toml"), "--size", "64x36", "--detail", "low"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::vector<std::uint8_t> bytes_of(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  bool has_parts() const {
    const std::filesystem::directory_iterator files(folder_.path());
    return std::any_of(begin(files), end(files), [](const auto& file) {
      return file.path().string().find(".partial") != std::string::npos;
    });
  }

  TemporaryFolder folder_;
};

// Fails if the video has other frames than the pictures have, by one byte, or is written without being asked
// for; if it cannot be had alone.
TEST_F(VideoProgramTest, HasTheFramesOfThePictures) {
  const StandInFfmpeg ffmpeg;
  const ProgramResult both =
      run_offing(arguments({"--record", path("out_%d.png"), "--video", path("a.webm")}));
  if (both.exit_code == 3) GTEST_SKIP() << both.errors;
  ASSERT_EQ(both.exit_code, 0) << both.errors;
  EXPECT_THAT(both.output, HasSubstr("out_2.png\n" + path("a.webm") + "\n"));
  std::vector<std::uint8_t> pictures;
  for (const char* name : {"out_0.png", "out_1.png", "out_2.png"}) {
    const RgbImage image = read_png(path(name));
    pictures.insert(pictures.end(), image.rgb.begin(), image.rgb.end());
  }
  EXPECT_TRUE(bytes_of("a.webm") == pictures);
  EXPECT_THAT(ffmpeg.arguments(), HasSubstr("\n64x36\n-framerate\n10\n"));
  ASSERT_EQ(run_offing(arguments({"--record", path("b.webm")})).exit_code, 0);
  EXPECT_TRUE(bytes_of("b.webm") == pictures);
  EXPECT_FALSE(has_parts());
}

// Fails if a machine without ffmpeg makes pictures first, or is told more than one line and a hint.
TEST_F(VideoProgramTest, NeedsFfmpeg) {
  const StandInFfmpeg ffmpeg;
  ffmpeg.take_away();
  const ProgramResult result =
      run_offing(arguments({"--record", path("a_%d.png"), "--video", path("a.mp4")}));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("a.mp4: expected the program ffmpeg on PATH, found none\nhint: "));
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 2);
  EXPECT_FALSE(std::filesystem::exists(path("a_0.png")));
}

// Fails if two videos are asked for and one is left out in silence, or flags of a recording are refused.
TEST_F(VideoProgramTest, OneVideoIsWritten) {
  const StandInFfmpeg ffmpeg;
  const ProgramResult result = run_offing(arguments({"--record", path("a.mp4"), "--video", path("b.mp4")}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("--record: expected picture names when --video is given"));
  EXPECT_EQ(run_offing(arguments({"--video", path("a.avi")})).exit_code, 2);
}

// Fails if a recording that is stopped leaves a part of its video, or the one that was there before is gone.
TEST_F(VideoProgramTest, StoppedOnesLeaveTheVideoBefore) {
  const StandInFfmpeg ffmpeg;
  std::ofstream(path("a.webm")) << "before";
  OffingProgram program(arguments({"--record", path("a_%d.png"), "--video", path("a.webm"), "--frames",
                                   "0:100000", "--force", "--quiet"}));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!std::filesystem::exists(path("a_1.png")) && program.is_running()) {
    ASSERT_LT(std::chrono::steady_clock::now(), end);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  program.send_signal(SIGINT);
  const ProgramResult result = program.wait();
  if (result.exit_code == 3) GTEST_SKIP() << result.errors;
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_THAT(result.errors, HasSubstr("the video was not made"));
  EXPECT_EQ(bytes_of("a.webm").size(), 6u);
  EXPECT_FALSE(has_parts());
}

}  // namespace
}  // namespace offing::test
