#pragma once

#include <atomic>
#include <functional>
#include <utility>

/// Long work: the token that stops it, and how far it is.
namespace offing {

/// A flag that asks long work to stop; polled between launches and frames. Safe to set from a signal handler.
class CancelToken {
 public:
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

  /// Throws Error(cancelled) when cancel() was called. The hint says how to go on.
  void throw_if_cancelled(const char* hint = "run the same command again to start over") const;

 private:
  std::atomic<bool> cancelled_{false};
  static_assert(std::atomic<bool>::is_always_lock_free, "cancel() must be safe in a signal handler");
};

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
