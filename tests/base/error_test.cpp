#include "host/base/error.h"

#include <exception>
#include <utility>

#include <gtest/gtest.h>

namespace offing {
namespace {

// Fails if scripts that tell wrong input, a missing device and a stop by the user apart see another status.
// The numbers are promised in docs/architecture.md.
TEST(ErrorTest, EachKindHasItsExitCode) {
  const std::pair<ErrorKind, int> promised[] = {{ErrorKind::bad_usage, 2},    {ErrorKind::bad_input, 2},
                                                {ErrorKind::no_device, 3},    {ErrorKind::out_of_memory, 1},
                                                {ErrorKind::build_failed, 1}, {ErrorKind::device, 1},
                                                {ErrorKind::file, 1},         {ErrorKind::cancelled, 130}};
  for (const auto& [kind, code] : promised) EXPECT_EQ(exit_code(kind), code) << static_cast<int>(kind);
}

// Fails if a part of an error is lost where it is caught by its base class and thrown on, as worker threads
// do.
TEST(ErrorTest, KeepsItsPartsWhenThrownOn) {
  std::exception_ptr kept;
  try {
    throw Error(ErrorKind::no_device, "no device", "install a driver");
  } catch (const std::exception& error) {
    EXPECT_STREQ(error.what(), "no device");
    kept = std::current_exception();
  }
  try {
    std::rethrow_exception(kept);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    EXPECT_STREQ(error.what(), "no device");
    EXPECT_EQ(error.hint(), "install a driver");
  }
}

// Fails if an error without a fix prints something as its hint.
TEST(ErrorTest, NeedsNoHint) {
  EXPECT_EQ(Error(ErrorKind::file, "cannot write").hint(), "");
}

}  // namespace
}  // namespace offing
