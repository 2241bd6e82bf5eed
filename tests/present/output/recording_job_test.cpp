// Recordings in the background whose work fails, or for which there is no thread.
#include "present/output/recording_job.h"

#include <new>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/present/no_threads.h"

namespace offing::present {
namespace {

ViewOptions two_frames() {
  ViewOptions options;
  options.recording = Recording{.frames = {0, 1}};
  return options;
}

/// What becomes of a recording whose work throws this.
template <class Fault>
Error fault_of(const Fault& fault) {
  RecordingJob job(two_frames(), [&](const auto&, const auto&, const auto&) { throw fault; });
  try {
    job.take();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return Error(ErrorKind::device, "");
}

// Fails if a fault of the thread reaches the window as anything but an Error, at which the window would end.
TEST(RecordingJobTest, FaultsAreErrors) {
  const Error usual = fault_of(Error(ErrorKind::file, "disk full", "make room"));
  EXPECT_EQ(usual.kind(), ErrorKind::file);
  EXPECT_EQ(usual.hint(), "make room");
  const Error memory = fault_of(std::bad_alloc());
  EXPECT_EQ(memory.kind(), ErrorKind::out_of_memory);
  EXPECT_FALSE(memory.hint().empty());
  const Error other = fault_of(std::runtime_error("oddity"));
  EXPECT_STREQ(other.what(), "recording: unexpected error: oddity");
  EXPECT_FALSE(other.hint().empty());
}

// Fails if a recording without a thread begins all the same, or throws what a window does not catch.
TEST(RecordingJobTest, NeedsAThread) {
  const test::NoThreads none;
  try {
    const RecordingJob job(two_frames(), [](const auto&, const auto&, const auto&) {});
    FAIL() << "it has a thread";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::out_of_memory);
    EXPECT_TRUE(std::string(error.what()).starts_with("recording: cannot start a thread")) << error.what();
  }
}

}  // namespace
}  // namespace offing::present
