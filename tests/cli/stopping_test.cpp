#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::test {
namespace {

// Fails if a kernel that does not build is reported as a stop, as it was about every second time: the handler
// of signals then read a token that was gone. 1 in 64 that six runs miss that.
TEST(Stopping, IsNotWhatABrokenKernelIs) {
  const TemporaryFolder kernels;
  std::filesystem::create_directory(kernels.path() / "ocean");
  std::ofstream(kernels.path() / "ocean/spectrum_advance.cl") << "kernel void spectrum_advance( {\n";
  const ScopedEnvironment environment("OFFING_KERNEL_PATH", kernels.path().string());
  for (int run = 0; run < 6; ++run) {
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

}  // namespace
}  // namespace offing::test
