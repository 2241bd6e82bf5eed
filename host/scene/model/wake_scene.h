#pragma once

#include <string>
#include <vector>

#include "host/ocean/wakes/wake_window.h"

namespace offing::scene {

/// A hull that moves through a wake window: from its place at time 0 straight ahead, or by its keyframes.
struct WakeHullScene {
  ocean::WakeHull hull;
  double speed_mps = 0.0;
};

/// What a wake window's centre follows.
enum class WakeCentre { place, hull, camera, body };

/// A wake window.
struct WakeScene {
  ocean::WakeParameters parameters{.step_s = 1.0 / 60.0};
  WakeCentre centre = WakeCentre::hull;
  double x_m = 0.0, z_m = 0.0;  ///< of the centre, or from the eye
  double behind_m = 0.0;        ///< of the centre behind the first hull or the body
  std::string body;             ///< name of the [[body]] that the centre follows; empty: the first
  double history_s = 30.0;      ///< how long a picture's wake has been growing at least
  std::vector<WakeHullScene> hulls;
};

}  // namespace offing::scene
