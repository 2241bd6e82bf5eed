#pragma once

#include <chrono>

namespace offing::present {

/// Keeps frames from coming faster than asked, where the display does not.
class FrameLimiter {
 public:
  /// Sleeps until a frame may follow the one before; does not catch up on frames that were late. 0 is no
  /// limit.
  void wait(double frames_per_second);

 private:
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
};

}  // namespace offing::present
