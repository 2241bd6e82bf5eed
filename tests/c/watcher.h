#pragma once

#include <vector>

#include "host/c/offing.h"

namespace offing {

/// Watches a call: keeps the shares, and stops it at one of them.
class Watcher {
 public:
  explicit Watcher(double stops_at = 2.0) : stops_at_(stops_at) {
    progress_.size = sizeof progress_;
    progress_.user = this;
    progress_.callback = [](void* user, double share) {
      auto* watcher = static_cast<Watcher*>(user);
      watcher->shares_.push_back(share);
      return share >= watcher->stops_at_ ? 7 : 0;
    };
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

  const OffingProgress* progress() const { return &progress_; }
  const std::vector<double>& shares() const { return shares_; }

 private:
  double stops_at_;
  OffingProgress progress_{};
  std::vector<double> shares_;
};

}  // namespace offing
