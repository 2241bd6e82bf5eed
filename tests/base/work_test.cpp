// Work that others wait for.
#include "host/base/work.h"

#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/base/time_estimate.h"

namespace offing {
namespace {

// Fails if parts of parts tell shares of themselves and not of the whole, or go on when it is to stop.
TEST(Work, PartsTellSharesOfTheWhole) {
  CancelToken cancel;
  std::vector<double> told;
  const Work whole(cancel, [&](double share) { told.push_back(share); });
  const Work half = whole.part(0.5, 1.0), quarter = half.part(0.0, 0.5);
  quarter.tell(0.0);
  quarter.tell(0.5);
  half.tell(1.0);
  EXPECT_EQ(told, (std::vector<double>{0.5, 0.625, 1.0}));
  cancel.cancel();
  EXPECT_THROW(quarter.poll(), Error);
  EXPECT_THROW(quarter.tell(0.7), Error);
  EXPECT_EQ(told.size(), 3u);
  EXPECT_NO_THROW(Work().part(0.0, 0.5).tell(0.3)) << "nobody waits for it";
}

// Fails if work of hours is begun, work of minutes is refused, or the time that is named is not that of the
// steps: 10 of 100,000 in 5 s are 50,000 s.
TEST(TimeEstimate, RefusesHours) {
  try {
    require_under_an_hour(10, 100'000, 5.0, "ocean.wake: 100000 steps", "take fewer");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_STREQ(error.what(),
                 "ocean.wake: 100000 steps would take about 13 h 53 min here, expected at most 1 h 00 min");
    EXPECT_EQ(error.hint(), "take fewer");
  }
  EXPECT_NO_THROW(require_under_an_hour(10, 1000, 5.0, "", ""));
  EXPECT_NO_THROW(require_under_an_hour(1, 1'000'000, 0.5, "", "")) << "too early to know";
}

// Fails if steps that would take hours go on for more than a few seconds, or what is only enqueued is not
// waited for: each step here takes 70 ms once it is waited for.
TEST(TimeEstimate, LooksWhileItWorks) {
  TimeEstimate estimate(1'000'000, "work", "take less");
  int enqueued = 0, done = 0;
  const auto finish = [&] {
    for (; enqueued > 0; --enqueued, ++done) std::this_thread::sleep_for(std::chrono::milliseconds(70));
  };
  EXPECT_THROW(
      {
        for (;;) {
          ++enqueued;
          estimate.step_done(finish);
        }
      },
      Error);
  EXPECT_GE(done, 16);
  EXPECT_LE(done, 64);
}

// Fails if the steps of a frame wait for the device.
TEST(TimeEstimate, FramesNeverWait) {
  TimeEstimate estimate(16, "work", "take less");
  for (int step = 0; step < 16; ++step) estimate.step_done([] { ADD_FAILURE() << "waited"; });
}

// Fails if work is refused because its first step waits for a driver's compiler: 2.1 s in place of nothing.
TEST(TimeEstimate, LeavesTheFirstStepOut) {
  TimeEstimate estimate(10'000, "work", "take less");
  estimate.step_done([] { std::this_thread::sleep_for(std::chrono::milliseconds(2100)); });
  for (int step = 1; step < 10'000; ++step) estimate.step_done([] {});
}

}  // namespace
}  // namespace offing
