// The wakes of a scene for commands that show nothing else of it.
#include "host/cli/ocean/wake_history.h"

#include <utility>
#include <vector>

#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_bodies.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_wakes.h"

namespace offing::cli {

std::optional<WakeHistory> WakeHistory::of(const ocl::Device& device, const scene::Scene& scene,
                                           const scene::Sea& sea) {
  if (scene.ocean.wakes.empty()) return std::nullopt;
  return WakeHistory(device, scene, sea);
}

WakeHistory::WakeHistory(const ocl::Device& device, const scene::Scene& scene, const scene::Sea& sea)
    : scene_(scene), wakes_(device, scene::prepare_wakes(scene, sea.spectrum.dispersion), 0.0) {
  std::vector<world::BodySettings> bodies = scene::prepare_bodies(scene, scene::prepare_meshes(scene));
  if (bodies.empty()) return;
  bodies_ = std::make_unique<world::WorldBodies>(device, std::move(bodies),
                                                 world::BodySea{sea.spectrum, sea.parameters, sea.wind},
                                                 scene::run_up_s(scene), 0.0);
}

void WakeHistory::at(double time_s) {
  if (bodies_) bodies_->reach(time_s);
  const Camera camera = scene::view_at(scene_, time_s).camera;
  wakes_.at(time_s, {camera.eye_m.x, camera.eye_m.z}, bodies_.get());
}

}  // namespace offing::cli
