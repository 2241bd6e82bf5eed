#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host/ocean/wakes/wake_maps.h"
#include "host/ocean/wakes/wake_window.h"
#include "host/world/world_bodies.h"

namespace offing::world {

/// One wake window of a world.
struct WakeSettings {
  ocean::WakeParameters parameters = {};
  ocean::WakeWindow::ForcingAt forcing_at = {};
  /// A picture after a leap in time, back or by more than this, shows a wake that has been growing for so
  /// long.
  double history_s = 30.0;
  bool is_about_eye = false;  ///< the forcing's centre is from the eye
  /// The body of the world that it follows, in a world with bodies; it is so far behind it. The forcing's
  /// centre says nothing then.
  std::optional<std::size_t> body = {};
  double behind_m = 0.0;
};

/// The wakes of a world: its windows, and their maps at the time that is shown.
class WorldWakes {
 public:
  /// `made_s` is the time that the world shows. Throws what WakeWindow throws.
  WorldWakes(const ocl::Device& device, const std::vector<WakeSettings>& settings, double made_s = 0.0);

  /// Enqueues the steps up to a time, as seen from an eye above this place, and the maps. Where there are
  /// bodies, which have reached this time, their hulls press on all windows, which go all the way with them:
  /// from their histories before the bodies' start on or, made later, before that time.
  void at(double time_s, const ocean::WaterPoint& eye, const WorldBodies* bodies = nullptr);

  /// From now on at() takes each window at most so many steps further, or twice the time that has passed if
  /// that is more; 0: all the way. A window that has not come that far shows its wake as it was then.
  void set_most_steps(int most) { most_steps_ = most; }
  /// Whether the last at() has left a window behind.
  bool is_behind() const { return is_behind_; }

  std::shared_ptr<const ocean::WakeMaps> maps() const { return maps_; }
  const std::vector<ocean::WakeWindow>& windows() const { return windows_; }
  /// About as high as its waves may be: what all hulls displace at that time.
  double reach_m(double time_s) const;

 private:
  ocean::WakeForcing forcing_at(const WakeSettings& settings, double time_s, const ocean::WaterPoint& eye,
                                const WorldBodies* bodies) const;

  double start_s(const WakeSettings& settings, double time_s, const WorldBodies* bodies) const;

  std::vector<WakeSettings> settings_;
  double made_s_;
  std::vector<ocean::WakeWindow> windows_;
  std::vector<bool> has_history_;
  int most_steps_ = 0;
  bool is_behind_ = false;
  double last_s_ = 0.0;  // of the last at()
  std::shared_ptr<ocean::WakeMaps> maps_;
};

}  // namespace offing::world
