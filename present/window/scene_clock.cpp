#include "present/window/scene_clock.h"

#include <algorithm>
#include <cmath>

namespace offing::present {

void SceneClock::advance(double wall_s, const std::optional<TimeSpan>& loop) {
  constexpr double longest_s = 0.25;
  if (is_paused_) return;
  time_s_ += scale_ * std::clamp(wall_s, 0.0, longest_s);
  if (loop && time_s_ >= loop->end_s)
    time_s_ = loop->first_s + std::fmod(time_s_ - loop->first_s, loop->length_s());
}

void SceneClock::set_scale(double scale) {
  constexpr double slowest = 1.0 / 64.0, fastest = 64.0;
  scale_ = std::clamp(scale, slowest, fastest);
}

void SceneClock::step(double seconds) {
  is_paused_ = true;
  time_s_ += seconds;
}

}  // namespace offing::present
