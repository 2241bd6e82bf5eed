#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace offing {

/// Refuses work of many steps that would take more than 45 s, or OFFING_LONGEST_WAIT_S of the environment,
/// before it shows anything. The estimate is from the steps done so far.
class TimeEstimate {
 public:
  /// What steps are like.
  enum class Steps {
    small,  ///< 16 are done in a frame without a wait; the first may compile kernels and counts for nothing
    large,  ///< 2 are done in a frame without a wait; the first counts, and kernels are compiled
  };

  /// `what` names the setting and the work, "ocean.wake: 432000 steps of 512 x 512 cells"; `hint` says how to
  /// ask for less. Large steps begin here: all that was enqueued before is to be finished.
  TimeEstimate(std::int64_t steps, std::string what, std::string hint, Steps size = Steps::small);

  /// To be called after each step. Of more steps than a frame takes, now and then waits by `finish` for those
  /// that are only enqueued, and then throws Error(bad_input) with the time needed if that is too long.
  void step_done(const std::function<void()>& finish = {});

 private:
  using Clock = std::chrono::steady_clock;

  const std::int64_t steps_;
  const std::string what_, hint_;
  const Steps size_;
  Clock::time_point start_ = Clock::now(), last_look_ = start_;  // of the first step that counts
  std::int64_t done_ = 0, next_look_;
};

/// Throws Error(bad_input) with the time needed if that is too long. `what` and `hint` are as above.
void require_short_wait(double needed_s, const std::string& what, const std::string& hint);
/// The check of TimeEstimate: the same for `steps` of which `done` took `elapsed_s`, unless that is too short
/// to say, or they are more than half of them.
void require_short_wait(std::int64_t done, std::int64_t steps, double elapsed_s, const std::string& what,
                        const std::string& hint);

}  // namespace offing
