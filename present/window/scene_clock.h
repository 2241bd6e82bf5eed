#pragma once

#include <optional>

namespace offing::present {

/// From one time up to another, which is later.
struct TimeSpan {
  double first_s = 0.0, end_s = 0.0;

  double length_s() const { return end_s - first_s; }
  bool operator==(const TimeSpan&) const = default;
};

/// The time that a window shows: it runs with the wall clock, faster, slower or not at all.
class SceneClock {
 public:
  explicit SceneClock(double start_s) : time_s_(start_s) {}

  double time_s() const { return time_s_; }
  double scale() const { return scale_; }
  bool is_paused() const { return is_paused_; }

  /// Passes on wall time. A frame that took longer than a quarter of a second, as while a window is dragged,
  /// counts as one of that length. With a loop, a time that reaches its end goes on from its begin.
  void advance(double wall_s, const std::optional<TimeSpan>& loop = {});
  void set_time(double time_s) { time_s_ = time_s; }
  /// Scene seconds a second, 1/64 ... 64.
  void set_scale(double scale);
  void toggle_pause() { is_paused_ = !is_paused_; }
  /// Pauses, and goes forward or back.
  void step(double seconds);

 private:
  double time_s_;
  double scale_ = 1.0;
  bool is_paused_ = false;
};

}  // namespace offing::present
