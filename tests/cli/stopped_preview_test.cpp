#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"

namespace offing::test {
namespace {

// Fails if a stop while a preview is drawn is told as anything but an interrupted bake, or leaves half a
// file.
TEST(StoppedPreview, IsAnInterruptedBake) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  OffingProgram program({"ocean", "bake", "--size", "16", "--cascades", "1", "--frames", "0:40", "--preview",
                         "-o", out.string()});
  while (program.is_running() && !std::filesystem::exists(out / "ocean.0000.png")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.send_signal(SIGINT);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_THAT(stopped.errors, testing::ContainsRegex("out: interrupted with [0-9]+ of 41 frames done"));
  EXPECT_THAT(stopped.errors, testing::HasSubstr("hint: run the same command again to make the others"));
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    EXPECT_THAT(entry.path().string(), testing::Not(testing::HasSubstr("partial")));
  }
}

}  // namespace
}  // namespace offing::test
