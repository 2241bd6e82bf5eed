#pragma once

#include <memory>
#include <vector>

#include "host/ocean/wake_maps.h"
#include "host/ocean/wake_window.h"

namespace offing::world {

/// One wake window of a world.
struct WakeSettings {
  ocean::WakeParameters parameters = {};
  ocean::WakeWindow::ForcingAt forcing_at = {};
  /// A picture after a leap in time, back or by more than this, shows a wake that has been growing for so
  /// long.
  double history_s = 30.0;
  bool is_about_eye = false;  ///< the forcing's centre is from the eye
};

/// The wakes of a world: its windows, and their maps at the time that is shown.
class WakeView {
 public:
  /// Throws what WakeWindow throws.
  WakeView(const ocl::Device& device, const std::vector<WakeSettings>& settings);

  /// Enqueues the steps up to a time, as seen from an eye above this place, and the maps.
  void at(double time_s, const ocean::WaterPoint& eye);

  std::shared_ptr<const ocean::WakeMaps> maps() const { return maps_; }
  const std::vector<ocean::WakeWindow>& windows() const { return windows_; }
  /// About as high as its waves may be: what all hulls displace at that time.
  double reach_m(double time_s) const;

 private:
  std::vector<WakeSettings> settings_;
  std::vector<ocean::WakeWindow> windows_;
  std::vector<bool> has_history_;
  std::shared_ptr<ocean::WakeMaps> maps_;
};

}  // namespace offing::world
