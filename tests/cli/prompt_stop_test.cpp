// Work of minutes that a signal stops.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"

namespace offing::test {
namespace {

class PromptStop : public testing::TestWithParam<int> {
 protected:
  /// Fails if the program is there for 2 s after the signal, or leaves unfinished files.
  void expect_stop(const std::vector<std::string>& arguments, std::chrono::seconds before_signal) {
    OffingProgram program(arguments);
    const auto signal_at = std::chrono::steady_clock::now() + before_signal;
    while (std::chrono::steady_clock::now() < signal_at && program.is_running())
      std::this_thread::sleep_for(std::chrono::milliseconds(80));
    ASSERT_TRUE(program.is_running()) << "over before the signal: " << program.wait().errors;
    const auto start = std::chrono::steady_clock::now();
    program.send_signal(GetParam());
    const ProgramResult stopped = program.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
    EXPECT_EQ(stopped.exit_code, 130);
    EXPECT_THAT(stopped.errors, testing::HasSubstr("hint: "));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
      EXPECT_THAT(entry.path().string(), testing::Not(testing::HasSubstr(".partial")));
    }
  }
  std::string path(const char* name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Signals, PromptStop, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_P(PromptStop, OfALargeBake) {
  expect_stop({"ocean", "bake", "--size", "4096", "--cascades", "4", "--frames", "0:9", "-o", path("frames")},
              std::chrono::seconds(8));
}

TEST_P(PromptStop, OfACloudOfTinyParticles) {
  std::ofstream(path("cloud.toml")) << "version = 1\n[[cloud]]\nmodelling = \"hierarchical\"\n"
                                       "[[cloud.ball]]\nradius_m = 300\n[[cloud.level]]\nratio = 0.02\n"
                                       "[[cloud.level]]\nratio = 0.02\n";
  // By then there are so many particles that going through them once takes longer than a stop may.
  expect_stop({"clouds", "build", path("cloud.toml"), "-o", path("cloud.ply")}, std::chrono::seconds(65));
}

}  // namespace
}  // namespace offing::test
