#pragma once

#include <glm/vec2.hpp>

#include "present/panels/panels.h"
#include "present/passes/live_sea.h"
#include "present/window/walking_camera.h"

namespace offing::present {

/// Moves the camera of a window over sea and ground, flying or on foot, and jumps to places. What cannot be
/// is answered by the state's message.
class CameraPilot {
 public:
  /// Moves by what was asked for in so much time: never into water or ground.
  void move(ViewState& state, LiveSea& sea, const CameraInput& input, double seconds);
  /// From flying to walking where there is ground, or back; false where there is none.
  bool toggle_walk(ViewState& state, LiveSea& sea) const;
  /// To a walker's height above a place on the ground, east and south of the origin; false beyond its edge.
  bool go_to(ViewState& state, LiveSea& sea, glm::dvec2 place_m) const;
  /// To the ground that a point of the picture shows, in clip coordinates; false where it shows none.
  bool go_through(ViewState& state, LiveSea& sea, glm::dvec2 clip) const;

 private:
  WalkingCamera walking_;
};

}  // namespace offing::present
