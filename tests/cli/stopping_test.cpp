#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "tests/cli/offing_program.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::test {
namespace {

// Fails if a kernel that does not build is reported as a stop, as it was about every second time: the handler
// of signals then read a token that was gone. 1 in 16 that four runs miss that.
TEST(Stopping, IsNotWhatABrokenKernelIs) {
  const TemporaryFolder kernels;
  std::filesystem::create_directory(kernels.path() / "ocean");
  std::ofstream(kernels.path() / "ocean/spectrum_advance.cl") << "kernel void spectrum_advance( {\n";
  const ScopedEnvironment environment("OFFING_KERNEL_PATH", kernels.path().string());
  for (int run = 0; run < 4; ++run) {
    const ProgramResult result =
        run_offing({"ocean", "stats", "--size", "16", "--cascades", "1", "--seeds", "1"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, testing::HasSubstr("kernels/ocean/spectrum_advance.cl does not build"));
  }
}

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

// Fails if the hint says that a store is begun anew: what is done is kept. The map is large enough for
// seconds.
TEST(Stopping, OfATileStoreSaysThatItResumes) {
  const TemporaryFolder folder;
  const std::string map = (folder.path() / "flat.r32").string();
  std::ofstream(map).close();
  std::filesystem::resize_file(map, 4ull * 8193 * 8193);
  OffingProgram program({"terrain", "tile", map, "--raw-size", "8193x8193", "--spacing-m", "10", "-o",
                         (folder.path() / "store").string()});
  while (program.is_running() && !std::filesystem::exists(folder.path() / "store/0")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.send_signal(SIGINT);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_THAT(stopped.errors, testing::HasSubstr("hint: run the same command again to resume"));
}

/// Points that come through a pipe with a name, which waits for whoever writes to it.
class StoppingAtAPipe : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(mkfifo(pipe().c_str(), 0600), 0); }

  std::string pipe() const { return (folder_.path() / "points.csv").string(); }
  std::vector<std::string> query() const {
    return {"ocean", "query", "--size", "16", "--cascades", "1", "--points", pipe()};
  }
  static void expect_stop(OffingProgram& program, int signal) {
    const auto start = std::chrono::steady_clock::now();
    program.send_signal(signal);
    const ProgramResult stopped = program.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
    EXPECT_EQ(stopped.exit_code, 130);
    EXPECT_THAT(stopped.errors, testing::HasSubstr("error: stopped at the user's request\nhint: "));
  }

  TemporaryFolder folder_;
};

// Fails if a program that waits for a pipe which nobody opens waits on after a signal.
TEST_F(StoppingAtAPipe, ThatNobodyWritesTo) {
  OffingProgram program(query());
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // until it handles signals
  expect_stop(program, SIGHUP);
}

// Fails if one that waits for more points does, or leaves half a file behind.
TEST_F(StoppingAtAPipe, ThatHasMoreToCome) {
  std::vector<std::string> arguments = query();
  arguments.insert(arguments.end(), {"-o", (folder_.path() / "out.csv").string()});
  OffingProgram program(arguments);
  std::fstream writer(pipe(), std::ios::in | std::ios::out);  // which does not wait for the program
  writer << "1,2\n" << std::flush;
  const auto names = [&] {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      found.push_back(entry.path().filename().string());
    return found;
  };
  while (program.is_running() && names().size() < 2)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_THAT(names(), testing::Contains(testing::EndsWith(".partial"))) << "nothing was begun";
  expect_stop(program, SIGTERM);
  EXPECT_THAT(names(), testing::ElementsAre("points.csv"));
}

// Fails if a program whose reader has had enough, as `head` has, ends by a signal or complains.
TEST(Stopping, IsWhatABrokenPipeDoes) {
  const TemporaryFolder folder;
  const std::string points = (folder.path() / "points.csv").string(),
                    errors = (folder.path() / "errors").string();
  {
    std::ofstream file(points);
    for (int i = 0; i < 20'000; ++i) file << i << ",0\n";
  }
  std::FILE* const reader = popen(
      ("exec \"" OFFING_PROGRAM "\" ocean query --size 16 --cascades 1 --points " + points + " 2> " + errors)
          .c_str(),
      "r");
  ASSERT_NE(reader, nullptr);
  EXPECT_NE(std::fgetc(reader), EOF);
  const int status = pclose(reader);
  ASSERT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(std::filesystem::file_size(errors), 0u);
}

}  // namespace
}  // namespace offing::test
