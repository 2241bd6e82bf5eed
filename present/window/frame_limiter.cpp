#include "present/window/frame_limiter.h"

#include <algorithm>
#include <thread>

namespace offing::present {

void FrameLimiter::wait(double frames_per_second) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point now = Clock::now();
  if (frames_per_second <= 0.0) {
    next_ = now;
    return;
  }
  std::this_thread::sleep_until(next_);
  const auto interval =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / frames_per_second));
  next_ = std::max(next_, now) + interval;
}

}  // namespace offing::present
