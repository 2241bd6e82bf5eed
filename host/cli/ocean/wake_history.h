#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host/scene/model/scene.h"
#include "host/scene/prepare/sea.h"
#include "host/world/world_bodies.h"
#include "host/world/world_wakes.h"

namespace offing::cli {

/// The wake windows of a scene at any time, with the bodies that press on them. They have a history: a later
/// time costs the steps in between, an earlier one those from the start.
class WakeHistory {
 public:
  /// Nothing without a wake window: bodies move the water of windows alone. Bodies float on the open sea.
  /// Throws what the simulations throw.
  static std::optional<WakeHistory> of(const ocl::Device& device, const scene::Scene& scene,
                                       const scene::Sea& sea);

  /// Enqueues the windows of this time; those about the camera are about the scene's own. Throws what
  /// WorldBodies::reach() and WorldWakes::at() throw.
  void at(double time_s);

  std::shared_ptr<const ocean::WakeMaps> maps() const { return wakes_.maps(); }
  const std::vector<ocean::WakeWindow>& windows() const { return wakes_.windows(); }

 private:
  WakeHistory(const ocl::Device& device, const scene::Scene& scene, const scene::Sea& sea);

  scene::Scene scene_;
  std::unique_ptr<world::WorldBodies> bodies_;
  world::WorldWakes wakes_;
};

}  // namespace offing::cli
