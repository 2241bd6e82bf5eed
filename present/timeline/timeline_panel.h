#pragma once

#include <optional>

#include "host/scene/model/scene.h"
#include "present/output/recorder.h"
#include "present/panels/panel_layout.h"
#include "present/panels/parameter_widget.h"
#include "present/timeline/keyframe_edits.h"
#include "present/timeline/time_scale.h"
#include "present/window/scene_clock.h"

namespace offing::present {

/// What a timeline keeps from frame to frame.
struct Timeline {
  enum class Part { nothing, time, range_start, range_end, keys };

  bool loops = false;         ///< time runs through the scene's time span over and over
  TimeScale scale = {};       ///< of the strip as it was drawn last
  Part held = Part::nothing;  ///< by the mouse
  bool plays_on = false;      ///< when the mouse lets go of the time
  bool is_moved = false;      ///< what the mouse holds, but for the time
  double held_s = 0.0;        ///< where keyframes were when the mouse took hold of them
  Tracks before = {};         ///< all keyframes then

  /// What the mouse holds stays where it is: it may not be there any more.
  void let_go();
};

/// What the user asked a timeline for in one frame.
struct TimelineEdits {
  Edit scene = Edit::none;
  bool wants_recording = false, cancels_recording = false;
};

/// Draws the timeline at the bottom of the window: the time of the scene, buttons that play and step, and a
/// strip with the scene's time span and its keyframes, along which the mouse drags the time, both ends of the
/// span and keyframes. Below it, how far a recording is.
TimelineEdits draw_timeline(scene::Scene& scene, SceneClock& clock, Timeline& timeline,
                            const std::optional<RecordingProgress>& recording, PanelLayout& layout);

/// The times that are played over and over; nothing without a loop.
std::optional<TimeSpan> played_span(const scene::Scene& scene, const Timeline& timeline);

}  // namespace offing::present
