// Wakes that take minutes before the first picture.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"

namespace offing::test {
namespace {

// Fails if a picture that takes minutes goes on for 2 s after a signal.
TEST(StoppedWakes, EndPromptly) {
  setenv("OFFING_LONGEST_WAIT_S", "3600", 1);
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "scene.toml").string();
  for (const char* window : {"cells = 4096\nhistory_s = 60\n", "cells = 256\nhistory_s = 3600\n"}) {
    std::ofstream(file) << "version = 1\n[ocean]\nsize = 16\n[[ocean.wake]]\nlength_m = 500\n"
                        << window << "[[ocean.wake.hull]]\nspeed_mps = 3\n";
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      OffingProgram program({file, "--headless", "-o", (folder.path() / "out.png").string()});
      for (int i = 0; i < 100 && program.is_running(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      ASSERT_TRUE(program.is_running()) << "over before the signal: " << program.wait().errors;
      const auto start = std::chrono::steady_clock::now();
      program.send_signal(signal);
      EXPECT_EQ(program.wait().exit_code, 130);
      EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << window << signal;
    }
  }
}

}  // namespace
}  // namespace offing::test
