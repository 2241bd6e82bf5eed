#include "host/base/process.h"

#include <csignal>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

int fail_to_build(const CancelToken&) {
  throw Error(ErrorKind::build_failed, "kernels/a.cl does not build", "update the driver");
}

// Fails if a build that a signal broke, by way of the files that LLVM deletes then, is told as a fault.
TEST(ProcessTest, ABuildBrokenByASignalIsAStop) {
  const auto stopped_while_building = [] {
    std::exit(run_program([](const CancelToken& cancel) {
      std::raise(SIGTERM);
      return fail_to_build(cancel);
    }));
  };
  EXPECT_EXIT(stopped_while_building(), testing::ExitedWithCode(130), "stopped at the user's request");
}

// Fails if a build that no signal broke is taken for a stop.
TEST(ProcessTest, ABuildThatFailsIsAFault) {
  const auto failing = [] { std::exit(run_program(fail_to_build)); };
  EXPECT_EXIT(failing(), testing::ExitedWithCode(exit_code(ErrorKind::build_failed)), "does not build");
}

}  // namespace
}  // namespace offing
