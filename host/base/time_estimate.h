#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace offing {

/// Refuses work of many steps that would take more than an hour before it shows anything. The estimate is
/// from the steps done so far, without the first.
class TimeEstimate {
 public:
  /// `what` names the setting and the work, "ocean.wake: 432000 steps of 512 x 512 cells"; `hint` says how to
  /// ask for less.
  TimeEstimate(std::int64_t steps, std::string what, std::string hint);

  /// To be called after each step. Of more than 16 steps, now and then waits by `finish` for those that are
  /// only enqueued, and then throws Error(bad_input) with the time needed if that is too long.
  void step_done(const std::function<void()>& finish = {});

 private:
  using Clock = std::chrono::steady_clock;

  const std::int64_t steps_;
  const std::string what_, hint_;
  Clock::time_point start_, last_look_;     // of the second step; of the last look
  std::int64_t done_ = 0, next_look_ = 16;  // more than most frames take
};

/// The check of TimeEstimate: throws if `steps` would take too long, given that `done` took `elapsed_s`.
void require_under_an_hour(std::int64_t done, std::int64_t steps, double elapsed_s, const std::string& what,
                           const std::string& hint);

}  // namespace offing
