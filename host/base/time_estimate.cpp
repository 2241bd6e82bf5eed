#include "host/base/time_estimate.h"

#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/progress.h"

namespace offing {
namespace {

constexpr double longest_s = 3600.0;
constexpr double least_elapsed_s = 2.0;
constexpr auto look_interval = std::chrono::seconds(1);
// What a frame takes: it never waits for the device.
constexpr std::int64_t few_steps = 16;

}  // namespace

void require_under_an_hour(std::int64_t done, std::int64_t steps, double elapsed_s, const std::string& what,
                           const std::string& hint) {
  const double needed_s = elapsed_s * static_cast<double>(steps) / static_cast<double>(done);
  if (elapsed_s < least_elapsed_s || needed_s <= longest_s) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{} would take about {} here, expected at most {}", what, duration_text(needed_s),
                          duration_text(longest_s)),
              hint);
}

TimeEstimate::TimeEstimate(std::int64_t steps, std::string what, std::string hint)
    : steps_(steps), what_(std::move(what)), hint_(std::move(hint)) {}

void TimeEstimate::step_done(const std::function<void()>& finish) {
  if (steps_ <= few_steps) return;
  ++done_;
  if (done_ == 1) {
    // It pays for what is made once: drivers compile kernels at their first launch, for seconds.
    if (finish) finish();
    start_ = last_look_ = Clock::now();
    return;
  }
  // Looking at twice as many steps each time bounds what is enqueued before the first second is over.
  const bool is_due = done_ >= next_look_ || Clock::now() - last_look_ >= look_interval;
  if (!is_due || done_ >= steps_) return;
  if (finish) finish();
  last_look_ = Clock::now();
  next_look_ = 2 * done_;
  require_under_an_hour(done_ - 1, steps_, std::chrono::duration<double>(last_look_ - start_).count(), what_,
                        hint_);
}

}  // namespace offing
