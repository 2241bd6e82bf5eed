// Work that others wait for.
#include "host/base/work.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/base/time_estimate.h"

namespace offing {
namespace {

CancelToken token_of_handler;

// Fails if a token that nobody cancelled stops work, or a cancelled one lets it go on, once or later.
TEST(CancelTokenTest, StopsWorkFromTheFirstCancelOn) {
  CancelToken token;
  EXPECT_FALSE(token.cancelled());
  EXPECT_NO_THROW(token.throw_if_cancelled());
  for (int i = 0; i < 2; ++i) {
    token.cancel();
    EXPECT_TRUE(token.cancelled());
    try {
      token.throw_if_cancelled();
      ADD_FAILURE() << "work goes on";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cancelled);
      EXPECT_FALSE(error.hint().empty());
      EXPECT_EQ(exit_code(error.kind()), 130);
    }
  }
}

// Fails if Ctrl-C does not reach the work: the handler is all that may run between two instructions.
TEST(CancelTokenTest, IsSetBySignalHandlers) {
  const auto previous = std::signal(SIGINT, [](int) { token_of_handler.cancel(); });
  ASSERT_EQ(std::raise(SIGINT), 0);
  std::signal(SIGINT, previous);
  EXPECT_TRUE(token_of_handler.cancelled());
}

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

/// A value of the environment for as long as this lives.
class LongestWait {
 public:
  explicit LongestWait(const char* value) {
    if (const char* usual = std::getenv("OFFING_LONGEST_WAIT_S")) usual_ = usual;
    if (value == nullptr) {
      unsetenv("OFFING_LONGEST_WAIT_S");
    } else {
      setenv("OFFING_LONGEST_WAIT_S", value, 1);
    }
  }
  LongestWait(const LongestWait&) = delete;
  LongestWait& operator=(const LongestWait&) = delete;
  ~LongestWait() {
    if (usual_) {
      setenv("OFFING_LONGEST_WAIT_S", usual_->c_str(), 1);
    } else {
      unsetenv("OFFING_LONGEST_WAIT_S");
    }
  }

 private:
  std::optional<std::string> usual_;
};

// Fails if work of minutes is begun, work of seconds is refused, the time that is named is not that of the
// steps (10 of 10,000 in 5 s are 5,000 s), or its hint does not lead to it.
TEST(TimeEstimate, RefusesMinutes) {
  {
    const LongestWait usual(nullptr);
    try {
      require_short_wait(10, 10'000, 5.0, "ocean.wake: 10000 steps", "take fewer");
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_STREQ(error.what(),
                   "ocean.wake: 10000 steps would take about 1 h 23 min here, expected at most 45 s");
      EXPECT_EQ(error.hint(), "take fewer; or wait: set OFFING_LONGEST_WAIT_S=7500");
    }
    EXPECT_NO_THROW(require_short_wait(10, 80, 5.0, "", ""));
    EXPECT_NO_THROW(require_short_wait(1, 1'000'000, 0.5, "", "")) << "too early to know";
    EXPECT_NO_THROW(require_short_wait(6, 10, 40.0, "", "")) << "half done";
    EXPECT_NO_THROW(require_short_wait(44.0, "", ""));
    EXPECT_THROW(require_short_wait(46.0, "", ""), Error);
  }
  const LongestWait longer("7500");
  EXPECT_NO_THROW(require_short_wait(10, 10'000, 5.0, "", ""));
}

// Fails if a limit that is no number is taken for none, or for zero.
TEST(TimeEstimate, NeedsALimitInSeconds) {
  for (const char* text : {"", "ten", "5 min", "0", "-1", "nan"}) {
    const LongestWait wrong(text);
    try {
      require_short_wait(10, 1000, 5.0, "", "");
      ADD_FAILURE() << "no error for \"" << text << '"';
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_usage);
      EXPECT_EQ(std::string(error.what()),
                std::string("OFFING_LONGEST_WAIT_S: expected seconds above 0, found \"") + text + '"');
    }
  }
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

// Fails if a hundred steps of 2 s each are not refused after the first, or those of a frame wait.
TEST(TimeEstimate, LooksAtTheFirstLargeStep) {
  const LongestWait usual(nullptr);
  TimeEstimate estimate(100, "work", "take less", TimeEstimate::Steps::large);
  EXPECT_THROW(estimate.step_done([] { std::this_thread::sleep_for(std::chrono::milliseconds(2100)); }),
               Error);
  TimeEstimate frame(2, "work", "take less", TimeEstimate::Steps::large);
  for (int step = 0; step < 2; ++step) frame.step_done([] { ADD_FAILURE() << "waited"; });
}

// Fails if work is refused because its first step waits for a driver's compiler: 2.1 s in place of nothing.
TEST(TimeEstimate, LeavesTheFirstStepOut) {
  TimeEstimate estimate(10'000, "work", "take less");
  estimate.step_done([] { std::this_thread::sleep_for(std::chrono::milliseconds(2100)); });
  for (int step = 1; step < 10'000; ++step) estimate.step_done([] {});
}

}  // namespace
}  // namespace offing
