#include "host/world/world_wakes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/base/parameter_check.h"

namespace offing::world {

WorldWakes::WorldWakes(const ocl::Device& device, const std::vector<WakeSettings>& settings, double made_s)
    : settings_(settings),
      made_s_(made_s),
      has_history_(settings.size(), false),
      maps_(std::make_shared<ocean::WakeMaps>(device)) {
  for (const WakeSettings& window : settings) windows_.emplace_back(device, window.parameters);
  last_s_ = std::numeric_limits<double>::max();  // none: nothing has passed at the first at()
}

ocean::WakeForcing WorldWakes::forcing_at(const WakeSettings& settings, double time_s,
                                          const ocean::WaterPoint& eye, const WorldBodies* bodies) const {
  ocean::WakeForcing forcing = settings.forcing_at(time_s);
  if (settings.is_about_eye) {
    forcing.centre = {forcing.centre.x_m + eye.x_m, forcing.centre.z_m + eye.z_m};
  }
  if (settings.body && bodies != nullptr && *settings.body < bodies->size()) {
    const bodies::BodyPose pose = bodies->pose(*settings.body, time_s);
    const double heading_rad = bodies::heading_of(pose);
    forcing.centre = {pose.mass_centre_m.x - settings.behind_m * std::cos(heading_rad),
                      pose.mass_centre_m.z - settings.behind_m * std::sin(heading_rad)};
  }
  return forcing;
}

double WorldWakes::start_s(const WakeSettings& settings, double time_s, const WorldBodies* bodies) const {
  if (bodies == nullptr) return std::max(time_s - settings.history_s, -largest_time_s);
  const double shown_s = time_s < made_s_ ? bodies->start_s() : std::max(bodies->start_s(), made_s_);
  return std::min(std::max(shown_s - settings.history_s, bodies->begin_s()), time_s);
}

void WorldWakes::at(double time_s, const ocean::WaterPoint& eye, const WorldBodies* bodies) {
  ocean::WakeWindow::AddDisplaced press, add_growth;
  if (bodies != nullptr) {
    press = [bodies](double at_s, const WakeGrid& grid, ocl::Buffer<float>& displaced) {
      bodies->press(at_s, grid, displaced);
    };
    add_growth = [bodies](double at_s, const WakeGrid& grid, ocl::Buffer<float>& growth) {
      bodies->add_growth(at_s, grid, growth);
    };
  }
  is_behind_ = false;
  double shown_s = time_s;
  // Each window comes nearer, however short its steps are.
  constexpr double leap_s = 1.0;
  const double passed_s = std::clamp(time_s - std::exchange(last_s_, time_s), 0.0, leap_s);
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    const WakeSettings& settings = settings_[i];
    ocean::WakeWindow& window = windows_[i];
    const auto forcing = [&](double at_s) { return forcing_at(settings, at_s, eye, bodies); };
    const double ahead_s = time_s - window.time_s();
    const bool is_leap = bodies == nullptr && ahead_s > settings.history_s + settings.parameters.step_s;
    if (!has_history_[i] || ahead_s < 0.0 || is_leap) {
      const double from_s = start_s(settings, time_s, bodies);
      window.reset(from_s, forcing(from_s).centre);
      has_history_[i] = true;
    }
    double until_s = time_s;
    if (most_steps_ > 0) {
      const double most_s = std::max(most_steps_ * settings.parameters.step_s, 2.0 * passed_s);
      until_s = std::min(time_s, window.time_s() + most_s);
    }
    window.advance_to(until_s, forcing, press, add_growth);
    if (until_s == time_s) continue;
    is_behind_ = true;
    shown_s = std::min(shown_s, until_s);
  }
  maps_->at(windows_, shown_s, press);
}

double WorldWakes::reach_m(double time_s) const {
  double sum_m = 0.0;
  for (const WakeSettings& settings : settings_) {
    for (const ocean::WakeHull& hull : settings.forcing_at(time_s).hulls) sum_m += hull.draught_m;
    if (settings.parameters.rain.drops_per_m2s > 0.0) sum_m += std::abs(settings.parameters.rain.hollow_m);
  }
  return sum_m;
}

}  // namespace offing::world
