#include "host/scene/prepare/scene_wakes.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/model/moving_number.h"
#include "host/scene/model/named_file.h"
#include "host/scene/prepare/scene_bodies.h"

namespace offing::scene {

namespace {

class HullMotion {
 public:
  HullMotion(const Scene& scene, const WakeHullScene& hull, ElementIndex element)
      : hull_(hull.hull),
        speed_mps_(hull.speed_mps),
        x_m_(scene, {"ocean.wake.hull.x_m", element}, hull.hull.x_m),
        z_m_(scene, {"ocean.wake.hull.z_m", element}, hull.hull.z_m),
        heading_rad_(scene, {"ocean.wake.hull.heading_deg", element}, hull.hull.heading_rad),
        draught_m_(scene, {"ocean.wake.hull.draught_m", element}, hull.hull.draught_m) {}

  ocean::WakeHull at(double time_s) const {
    ocean::WakeHull hull = hull_;
    hull.heading_rad = heading_rad_.at(time_s);
    hull.x_m = x_m_.at(time_s) + speed_mps_ * time_s * std::cos(hull.heading_rad);
    hull.z_m = z_m_.at(time_s) + speed_mps_ * time_s * std::sin(hull.heading_rad);
    hull.draught_m = draught_m_.at(time_s);
    return hull;
  }

 private:
  ocean::WakeHull hull_;
  double speed_mps_;
  MovingNumber x_m_, z_m_, heading_rad_, draught_m_;
};

class WakeMotion {
 public:
  WakeMotion(const Scene& scene, std::size_t index)
      : follows_hull_(scene.ocean.wakes[index].centre == WakeCentre::hull &&
                      !scene.ocean.wakes[index].hulls.empty()),
        behind_m_(scene.ocean.wakes[index].behind_m),
        x_m_(scene, {"ocean.wake.x_m", {index, 0}}, scene.ocean.wakes[index].x_m),
        z_m_(scene, {"ocean.wake.z_m", {index, 0}}, scene.ocean.wakes[index].z_m) {
    for (std::size_t i = 0; i < scene.ocean.wakes[index].hulls.size(); ++i) {
      hulls_.emplace_back(scene, scene.ocean.wakes[index].hulls[i], ElementIndex{index, i});
    }
  }

  ocean::WakeForcing at(double time_s) const {
    ocean::WakeForcing forcing{.centre = {x_m_.at(time_s), z_m_.at(time_s)}};
    for (const HullMotion& hull : hulls_) forcing.hulls.push_back(hull.at(time_s));
    if (follows_hull_) {
      const ocean::WakeHull& first = forcing.hulls.front();
      forcing.centre = {first.x_m - behind_m_ * std::cos(first.heading_rad),
                        first.z_m - behind_m_ * std::sin(first.heading_rad)};
    }
    return forcing;
  }

 private:
  bool follows_hull_;
  double behind_m_;
  MovingNumber x_m_, z_m_;
  std::vector<HullMotion> hulls_;
};

}  // namespace

std::vector<world::WakeSettings> prepare_wakes(const Scene& scene, const ocean::Dispersion& dispersion) {
  std::vector<world::WakeSettings> prepared;
  for (std::size_t i = 0; i < scene.ocean.wakes.size(); ++i) {
    const WakeScene& wake = scene.ocean.wakes[i];
    if (wake.parameters.cells != scene.ocean.wakes.front().parameters.cells) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected as many cells as in the first window, {}, got {}",
                              place_of_name(scene, {"ocean.wake.cells", {i, 0}}),
                              scene.ocean.wakes.front().parameters.cells, wake.parameters.cells),
                  "give all windows the same cells, and lengths of their own");
    }
    world::WakeSettings settings{.parameters = wake.parameters,
                                 .history_s = wake.history_s,
                                 .is_about_eye = wake.centre == WakeCentre::camera};
    if (wake.centre == WakeCentre::body) {
      settings.body = followed_body(scene, i);
      settings.behind_m = wake.behind_m;
    }
    settings.parameters.dispersion = dispersion;
    settings.parameters.rain.seed = scene.world.seed;
    // Shared, because functions are copied.
    const auto motion = std::make_shared<const WakeMotion>(scene, i);
    settings.forcing_at = [motion](double time_s) { return motion->at(time_s); };
    prepared.push_back(std::move(settings));
  }
  return prepared;
}

}  // namespace offing::scene
