#pragma once

#include <atomic>

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

}  // namespace offing
