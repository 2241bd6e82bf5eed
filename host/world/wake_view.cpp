#include "host/world/wake_view.h"

#include <algorithm>
#include <cmath>

#include "host/base/world_limits.h"

namespace offing::world {

WakeView::WakeView(const ocl::Device& device, const std::vector<WakeSettings>& settings)
    : settings_(settings),
      has_history_(settings.size(), false),
      maps_(std::make_shared<ocean::WakeMaps>(device)) {
  for (const WakeSettings& window : settings) windows_.emplace_back(device, window.parameters);
}

void WakeView::at(double time_s, const ocean::WaterPoint& eye) {
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    const WakeSettings& settings = settings_[i];
    ocean::WakeWindow& window = windows_[i];
    const auto forcing_at = [&](double at_s) {
      ocean::WakeForcing forcing = settings.forcing_at(at_s);
      if (settings.is_about_eye) {
        forcing.centre = {forcing.centre.x_m + eye.x_m, forcing.centre.z_m + eye.z_m};
      }
      return forcing;
    };
    const double ahead_s = time_s - window.time_s();
    if (!has_history_[i] || ahead_s < 0.0 || ahead_s > settings.history_s + settings.parameters.step_s) {
      const double start_s = std::max(time_s - settings.history_s, -largest_time_s);
      window.reset(start_s, forcing_at(start_s).centre);
      has_history_[i] = true;
    }
    window.advance_to(time_s, forcing_at);
  }
  maps_->at(windows_, time_s);
}

double WakeView::reach_m(double time_s) const {
  double sum_m = 0.0;
  for (const WakeSettings& settings : settings_) {
    for (const ocean::WakeHull& hull : settings.forcing_at(time_s).hulls) sum_m += hull.draught_m;
    if (settings.parameters.rain.drops_per_m2s > 0.0) sum_m += std::abs(settings.parameters.rain.hollow_m);
  }
  return sum_m;
}

}  // namespace offing::world
