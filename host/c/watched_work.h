#pragma once

#include <algorithm>

#include "host/base/error.h"
#include "host/base/work.h"
#include "host/c/call.h"
#include "host/c/offing.h"

namespace offing::c {

/// Long work of a call, as the program's callback sees it.
class WatchedWork {
 public:
  explicit WatchedWork(const OffingProgress* progress)
      : progress_(read_struct(progress, "progress")), work_(cancel_, [this](double share) { show(share); }) {
    work_.tell(0.0);
  }
  WatchedWork(const WatchedWork&) = delete;
  WatchedWork& operator=(const WatchedWork&) = delete;

  const CancelToken& cancel() const { return cancel_; }
  /// Whose tell() throws Error(cancelled) where the callback asks to stop.
  const Work& work() const { return work_; }

 private:
  void show(double share) {
    constexpr double step = 0.001;  // callbacks may cost more than what they report
    share = std::clamp(share, 0.0, 1.0);
    const bool is_seen = shown_ < 0.0 || share >= shown_ + step || (share == 1.0 && shown_ < 1.0);
    if (progress_.callback == nullptr || !is_seen) return;
    shown_ = share;
    if (progress_.callback(progress_.user, share) == 0) return;
    cancel_.cancel();
    throw Error(ErrorKind::cancelled, "stopped by the callback of OffingProgress",
                "let it return 0 to go on, and call again");
  }

  OffingProgress progress_;
  CancelToken cancel_;
  Work work_;
  double shown_ = -1.0;  // before the first share
};

}  // namespace offing::c
