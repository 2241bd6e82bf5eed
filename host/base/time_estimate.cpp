#include "host/base/time_estimate.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/progress.h"

namespace offing {
namespace {

constexpr const char* limit_name = "OFFING_LONGEST_WAIT_S";
// With what comes before and after, a first picture is there within a minute.
constexpr double usual_limit_s = 45.0;
constexpr double least_elapsed_s = 2.0;
constexpr auto look_interval = std::chrono::seconds(1);
// What a frame takes: it never waits for the device.
constexpr std::int64_t few_small_steps = 16, few_large_steps = 2;

double limit_s() {
  const char* text = std::getenv(limit_name);
  if (text == nullptr) return usual_limit_s;
  char* end = nullptr;
  const double limit = std::strtod(text, &end);
  if (*text != '\0' && *end == '\0' && limit > 0.0) return limit;
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected seconds above 0, found \"{}\"", limit_name, text),
              fmt::format("set it to 600, or unset it for {:g}", usual_limit_s));
}

}  // namespace

void require_short_wait(double needed_s, const std::string& what, const std::string& hint) {
  const double longest_s = limit_s();
  if (std::round(needed_s) <= longest_s) return;  // as it would be shown
  constexpr double margin = 1.5;
  throw Error(ErrorKind::bad_input,
              fmt::format("{} would take about {} here, expected at most {}", what, duration_text(needed_s),
                          duration_text(longest_s)),
              fmt::format("{}; or wait: set {}={:.0f}", hint, limit_name, std::ceil(margin * needed_s)));
}

void require_short_wait(std::int64_t done, std::int64_t steps, double elapsed_s, const std::string& what,
                        const std::string& hint) {
  // What is half done was begun in good faith: a machine that gets slower is no reason to throw it away.
  if (elapsed_s < least_elapsed_s || 2 * done > steps) return;
  require_short_wait(elapsed_s * static_cast<double>(steps) / static_cast<double>(done), what, hint);
}

TimeEstimate::TimeEstimate(std::int64_t steps, std::string what, std::string hint, Steps size)
    : steps_(steps),
      what_(std::move(what)),
      hint_(std::move(hint)),
      size_(size),
      next_look_(size == Steps::small ? few_small_steps : 1) {}

void TimeEstimate::step_done(const std::function<void()>& finish) {
  if (steps_ <= (size_ == Steps::small ? few_small_steps : few_large_steps)) return;
  ++done_;
  if (done_ == 1 && size_ == Steps::small) {
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
  const std::int64_t counted = size_ == Steps::small ? done_ - 1 : done_;
  require_short_wait(counted, steps_, std::chrono::duration<double>(last_look_ - start_).count(), what_,
                     hint_);
}

}  // namespace offing
