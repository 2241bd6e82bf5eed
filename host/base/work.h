#pragma once

#include <functional>
#include <utility>

#include "host/base/cancel_token.h"

namespace offing {

/// Long work, as those see it who wait for it: how far it is, and that it is to stop.
class Work {
 public:
  /// Which nobody waits for.
  Work() = default;
  /// `progress` is told the share that is done, 0 ... 1, never less than before. The token outlives the work.
  explicit Work(const CancelToken& cancel, std::function<void(double)> progress = {})
      : cancel_(&cancel), progress_(std::move(progress)) {}

  /// Throws Error(cancelled) where it is to stop. Costs next to nothing.
  void poll() const {
    if (cancel_ != nullptr) cancel_->throw_if_cancelled();
  }
  /// poll(), and tells the share that is done.
  void tell(double share) const {
    poll();
    if (progress_) progress_(share);
  }
  /// A part of this work, from one share of it to another. This work outlives it.
  Work part(double from, double to) const {
    if (cancel_ == nullptr) return {};
    return Work(*cancel_, [this, from, to](double share) { tell(from + (to - from) * share); });
  }

 private:
  const CancelToken* cancel_ = nullptr;
  std::function<void(double)> progress_;
};

}  // namespace offing
