#include "present/editing/cloud_builder.h"

#include <exception>
#include <new>

#include "host/scene/prepare/own_billboards.h"
#include "host/scene/prepare/scene_clouds.h"
#include "present/background_work.h"
#include "present/passes/clouds/cloud_pass.h"

namespace offing::present {
namespace {

std::pair<std::string, std::string> folders_of(const scene::Scene& scene) {
  return {scene.cloud_settings.crisp_billboards, scene.cloud_settings.soft_billboards};
}

}  // namespace

CloudBuilder::CloudBuilder(const ocl::DeviceInfo& device, const scene::Scene& shown)
    : grower_(ocl::Device::open(device)),
      billboard_folders_(folders_of(shown)),
      thread_(start_thread("clouds", [this] { work(); })) {}

CloudBuilder::~CloudBuilder() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    waiting_.reset();
    if (running_ != nullptr) running_->cancel();
  }
  changed_.notify_all();
  thread_.join();
}

world::CloudSkyParameters CloudBuilder::grow(world::CloudSkyParameters sky, const CancelToken& cancel,
                                             const std::function<void(world::CloudProgress)>& progress) {
  return grower_.grown(std::move(sky), cancel, progress);
}

void CloudBuilder::begin(const scene::Scene& scene, Haste haste) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = scene;
    if (haste == Haste::interrupt && running_ != nullptr) running_->cancel();
  }
  changed_.notify_all();
}

std::optional<std::variant<BuiltClouds, Error>> CloudBuilder::take() {
  const std::lock_guard lock(mutex_);
  if (ready_ && std::holds_alternative<BuiltClouds>(*ready_)) {
    std::get<BuiltClouds>(*ready_).billboards = std::exchange(ready_billboards_, std::nullopt);
  }
  return std::exchange(ready_, std::nullopt);
}

void CloudBuilder::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !waiting_ && running_ == nullptr; });
}

std::optional<world::CloudProgress> CloudBuilder::progress() const {
  const std::lock_guard lock(mutex_);
  if (!waiting_ && running_ == nullptr) return {};
  return progress_;
}

std::variant<BuiltClouds, Error> CloudBuilder::built(const scene::Scene& scene,
                                                     std::optional<clouds::BillboardTextures>& billboards) {
  try {
    BuiltClouds result{.scene = scene, .sky = {}, .billboards = {}};
    if (folders_of(scene) != billboard_folders_) {
      billboards = scene::own_billboards(scene);
      if (!billboards) billboards = built_in_billboards();
      billboard_folders_ = folders_of(scene);
    }
    result.sky = scene::prepare_clouds(scene, shapes_);
    if (result.sky) {
      const auto show = [this](world::CloudProgress progress) {
        const std::lock_guard lock(mutex_);
        progress_ = progress;
      };
      result.sky = grower_.grown(std::move(*result.sky), *running_, show, world::LongWork::done);
      built_in_billboards();  // for the pass that draws them, which would have to wait for them
    }
    return result;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorKind::out_of_memory, "clouds: too many particles for this machine's memory",
                 "lower cloud.target_particles or clouds.quality");
  } catch (const std::exception& error) {
    return unexpected_error("clouds", error);
  }
}

void CloudBuilder::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return waiting_ || is_closing_; });
    if (is_closing_) return;
    const scene::Scene scene = *std::exchange(waiting_, std::nullopt);
    CancelToken cancel;
    running_ = &cancel;
    progress_ = world::CloudProgress{};
    std::optional<clouds::BillboardTextures> billboards;
    lock.unlock();
    std::variant<BuiltClouds, Error> result = built(scene, billboards);
    lock.lock();
    running_ = nullptr;
    // Where a newer scene waits, nobody needs what was given up.
    if (!cancel.cancelled()) ready_ = std::move(result);
    if (billboards) ready_billboards_ = std::move(billboards);
    changed_.notify_all();
  }
}

}  // namespace offing::present
