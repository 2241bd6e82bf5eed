#include "present/passes/world_opening.h"

#include <algorithm>
#include <utility>

#include "host/base/error.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/prepare/world_scene.h"
#include "present/background_work.h"

namespace offing::present {

namespace {

/// Whether a scene has clouds, and looks as it does with them but for them.
bool stands_without_clouds(const scene::Scene& scene) {
  return scene.has_clouds() && (scene.ocean.is_given || scene.terrain.is_given || !scene.meshes.empty());
}

}  // namespace

void show_view(world::World& world, const FirstView& view, const glm::dvec3& eye_m) {
  constexpr int fewest_samples = 32;  // along a patch of the sea, unless a scene asks for fewer
  world.set_eye({eye_m.x, eye_m.z});
  world.set_light_lag(view.quality.light_lag);
  world.set_sea_samples(std::max(fewest_samples, world.parameters().ocean.size >> view.quality.sea_halvings));
  world.set_cloud_halvings(view.quality.cloud_halvings);
  world.set_most_wake_steps(view.quality.most_wake_steps);
  world.at(view.time_s, eye_m.y);
}

WorldOpening::WorldOpening(const ocl::Device& device, const scene::Scene& scene,
                           std::optional<FirstView> view, const CancelToken* cancel) {
  begin("the scene");
  const Error no_memory(ErrorKind::out_of_memory, "this machine's memory is too small for the scene",
                        "take a smaller ocean.size or terrain.posts, a coarser map, or fewer particles");
  world_ = run_in_background("the scene", no_memory, [this, device, scene, view, cancel] {
    const CancelToken none;
    return open(device, scene, view, cancel != nullptr ? *cancel : none);
  });
}

OpeningStep WorldOpening::step() const {
  const std::lock_guard lock(mutex_);
  return step_;
}

bool WorldOpening::wait_for(std::chrono::milliseconds time) const {
  return world_.wait_for(time) == std::future_status::ready;
}

void WorldOpening::begin(const char* work) {
  const std::lock_guard lock(mutex_);
  step_ = {work, {}};
}

OpenedWorld WorldOpening::open(const ocl::Device& device, scene::Scene scene, std::optional<FirstView> view,
                               const CancelToken& cancel) {
  OpenedWorld opened;
  opened.builder = std::make_unique<CloudBuilder>(device.info(), scene);
  if (view && view->clouds == FirstClouds::later && stands_without_clouds(scene)) {
    opened.with_clouds = scene;
    scene::copy_clouds({}, scene);
  }
  world::WorldParameters parameters = scene::prepare_shown_world(scene, Work(cancel));
  cancel.throw_if_cancelled();
  if (parameters.clouds) {
    begin("the clouds");
    const auto tell = [this](world::CloudProgress progress) {
      const std::lock_guard lock(mutex_);
      step_.share = progress.all > 0 ? (static_cast<double>(progress.done) + progress.share) /
                                           static_cast<double>(progress.all)
                                     : 1.0;
    };
    parameters.clouds = opened.builder->grow(std::move(*parameters.clouds), cancel, tell);
  }
  begin("kernels, sea and ground");
  opened.world = std::make_unique<world::World>(device, parameters);
  cancel.throw_if_cancelled();
  begin("waves, wakes and light of the first picture");
  show_view(*opened.world, view.value_or(FirstView{.time_s = scene.time.start_s}), scene.view.camera.eye_m);
  opened.world->see_clouds(scene.view.camera);
  device.finish();
  if (opened.with_clouds) opened.with_clouds->view.camera = scene.view.camera;
  opened.scene = std::move(scene);
  return opened;
}

}  // namespace offing::present
