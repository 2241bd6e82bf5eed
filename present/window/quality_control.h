#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "present/passes/quality.h"

namespace offing::present {

/// Chooses the quality level of quality_levels whose frames take no longer than is asked for, from those that
/// were drawn: coarser where they took too long, finer where a finer quality level's can be expected to fit.
/// It stays on a quality level for two seconds at least, and comes back to one that did not fit after six
/// seconds at the earliest, after four times as long the next time, and so on up to a minute.
class QualityControl {
 public:
  explicit QualityControl(std::size_t level = 0) : level_(level) {}

  /// Takes the time of a frame drawn on the current quality level, without waiting for a display, and when it
  /// ended.
  void note(double frame_ms, double wanted_ms, double now_s);

  /// Frames stop coming for a while: those that follow are looked at by themselves.
  void rest() { since_s_.reset(); }

  std::size_t level() const { return level_; }
  const Quality& quality() const { return quality_levels.at(level_); }

 private:
  struct Memory {
    double frame_ms = 0.0, at_s = 0.0, kept_s = 0.0;
  };

  double expected_ms(std::size_t level, double usual_ms, double now_s) const;
  /// From a quality level whose frames took so long.
  void go_to(std::size_t level, double usual_ms, double now_s);

  std::size_t level_;
  std::optional<double> since_s_;  // on this quality level, its first frame drawn; nothing: not yet
  double window_s_ = 0.0;          // when the frames that are looked at together began
  std::vector<double> frames_ms_;  // since then
  std::array<std::optional<Memory>, quality_levels.size()>
      memory_;  // what quality levels took that were left
};

}  // namespace offing::present
