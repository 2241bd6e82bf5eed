#include "present/timeline/time_scale.h"

#include <algorithm>
#include <cmath>

namespace offing::present {

float TimeScale::x_px(double time_s) const {
  return left_px + static_cast<float>((time_s - span.first_s) / span.length_s()) * width_px;
}

double TimeScale::time_s(float x_px) const {
  const double share = static_cast<double>((x_px - left_px) / width_px);
  return span.first_s + std::clamp(share, 0.0, 1.0) * span.length_s();
}

TimeSpan shown_span(const scene::Scene& scene, double time_s) {
  constexpr double least_s = 0.1;
  TimeSpan span{scene.time.start_s, scene.time.end_s};
  for (const auto& [key, track] : scene.tracks) {
    span.first_s = std::min(span.first_s, track.keys.front().time_s);
    span.end_s = std::max(span.end_s, track.keys.back().time_s);
  }
  span.end_s = std::max(span.end_s, span.first_s + least_s);
  while (time_s > span.end_s) span.end_s = span.first_s + 2.0 * span.length_s();
  while (time_s < span.first_s) span.first_s = span.end_s - 2.0 * span.length_s();
  return span;
}

double mark_step_s(const TimeScale& scale, float least_px) {
  const double least_s = scale.span.length_s() * static_cast<double>(least_px / scale.width_px);
  const double decade_s = std::pow(10.0, std::floor(std::log10(least_s)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade_s >= least_s) return step * decade_s;
  }
  return 10.0 * decade_s;
}

std::optional<TimeSpan> loop_span(const scene::TimeSection& time) {
  if (!(time.end_s > time.start_s)) return {};
  return TimeSpan{time.start_s, time.end_s};
}

double nearest_frame_s(double time_s, double frames_per_second) {
  return std::round(time_s * frames_per_second) / frames_per_second;
}

double last_frame_s(const scene::TimeSection& time) {
  const double last = std::ceil(time.end_s * time.frames_per_second - 1e-9) - 1.0;
  return std::max(time.start_s, last / time.frames_per_second);
}

}  // namespace offing::present
