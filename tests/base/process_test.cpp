#include "host/base/process.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "host/base/error.h"

namespace offing {
namespace {

using Clock = std::chrono::steady_clock;
using testing::ExitedWithCode;

constexpr int interrupted = 130;

int fail_to_build(const CancelToken&) {
  throw Error(ErrorKind::build_failed, "kernels/a.cl does not build", "update the driver");
}

[[noreturn]] int wait_for_ever() {
  for (;;) pause();
}

void exit_with(const std::function<int(const CancelToken&)>& work) {
  std::exit(run_program(work));
}

// Fails if a build that a signal broke, by way of the files that LLVM deletes then, is told as a fault.
TEST(ProcessTest, ABuildBrokenByASignalIsAStop) {
  const auto stopped_while_building = [](const CancelToken& stop) {
    std::raise(SIGTERM);
    return fail_to_build(stop);
  };
  EXPECT_EXIT(exit_with(stopped_while_building), ExitedWithCode(interrupted),
              "stopped at the user's request");
}

// Fails if a build that no signal broke is taken for a stop.
TEST(ProcessTest, ABuildThatFailsIsAFault) {
  EXPECT_EXIT(exit_with(fail_to_build), ExitedWithCode(exit_code(ErrorKind::build_failed)), "does not build");
}

// Fails if work that does not look at its token goes on after a signal that asks it to stop.
TEST(ProcessTest, WorkThatGoesOnIsEnded) {
  const auto start = Clock::now();
  const auto deaf = [](const CancelToken&) {
    std::raise(SIGHUP);
    return wait_for_ever();
  };
  EXPECT_EXIT(exit_with(deaf), ExitedWithCode(interrupted), "error: stopped at the user's request\nhint: ");
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(2));
}

// Fails if the second signal, be it another one, does not end the process at once, or a file that is not
// whole stays behind.
TEST(ProcessTest, TheSecondSignalEndsAtOnce) {
  const std::string file = testing::TempDir() + "offing_unfinished_" + std::to_string(getpid());
  for (const auto& signals :
       {std::pair(SIGINT, SIGTERM), std::pair(SIGTERM, SIGHUP), std::pair(SIGHUP, SIGINT)}) {
    std::ofstream(file) << "half";
    const auto start = Clock::now();
    const auto deaf = [&](const CancelToken&) {
      mark_unfinished(file.c_str());
      std::raise(signals.first);
      std::raise(signals.second);
      return wait_for_ever();
    };
    EXPECT_EXIT(exit_with(deaf), ExitedWithCode(interrupted), "stopped at the user's request");
    EXPECT_LT(Clock::now() - start, std::chrono::milliseconds(900))
        << "the time that work has to end by itself";
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

// Fails if a file that is whole, or was taken back, goes with those that are not.
TEST(ProcessTest, FilesThatAreWholeStay) {
  const std::string file = testing::TempDir() + "offing_whole_" + std::to_string(getpid());
  std::ofstream(file) << "whole";
  const auto done = [&](const CancelToken&) {
    mark_unfinished(file.c_str());
    unmark_unfinished(file.c_str());
    std::raise(SIGINT);
    std::raise(SIGINT);
    return wait_for_ever();
  };
  EXPECT_EXIT(exit_with(done), ExitedWithCode(interrupted), "");
  EXPECT_TRUE(std::filesystem::remove(file));
}

// Fails if a program whose output nobody reads any more does not stop, or complains about it.
TEST(ProcessTest, ABrokenPipeIsAStopWithoutAWord) {
  const auto talkative = [](const CancelToken& stop) {
    for (;;) {
      std::raise(SIGPIPE);
      stop.throw_if_cancelled();
    }
    return 0;
  };
  EXPECT_EXIT(exit_with(talkative), ExitedWithCode(interrupted), testing::Eq(""));
}

// Fails if a program that was started to outlive its terminal (nohup) ends with it.
TEST(ProcessTest, NohupIsRespected) {
  const auto survivor = [](const CancelToken& stop) {
    std::raise(SIGHUP);
    return stop.cancelled() ? 1 : 0;
  };
  const auto started_by_nohup = [&] {
    std::signal(SIGHUP, SIG_IGN);
    exit_with(survivor);
  };
  EXPECT_EXIT(started_by_nohup(), ExitedWithCode(0), "");
}

}  // namespace
}  // namespace offing
