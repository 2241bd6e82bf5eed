#pragma once

#include <optional>

#include "host/scene/model/scene.h"
#include "present/window/scene_clock.h"

namespace offing::present {

/// Times along a strip of the screen.
struct TimeScale {
  TimeSpan span{0.0, 1.0};
  float left_px = 0.0f, width_px = 1.0f;

  float x_px(double time_s) const;
  /// Of a place beyond the strip, that of its nearer end.
  double time_s(float x_px) const;
};

/// What a timeline shows: the scene's time span and all keyframes, made longer by doubling until the time
/// that is shown lies within.
TimeSpan shown_span(const scene::Scene& scene, double time_s);

/// Seconds between marks: 1, 2 or 5 times a power of ten, so that marks are at least so far apart.
double mark_step_s(const TimeScale& scale, float least_px);

/// The scene's frames from start_s up to end_s, for playing them over and over. Nothing if it has none.
std::optional<TimeSpan> loop_span(const scene::TimeSection& time);

/// Time of the frame that is nearest; frame i is at i / frames_per_second.
double nearest_frame_s(double time_s, double frames_per_second);
/// Time of the last frame before end_s; start_s if there is none.
double last_frame_s(const scene::TimeSection& time);

}  // namespace offing::present
