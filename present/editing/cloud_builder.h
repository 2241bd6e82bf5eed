#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "host/base/error.h"
#include "host/base/work.h"
#include "host/clouds/image/billboard_textures.h"
#include "host/ocl/device_list.h"
#include "host/scene/model/scene.h"
#include "host/scene/prepare/cloud_shapes.h"
#include "host/world/cloud_grower.h"

namespace offing::present {

/// The clouds of an edited scene, ready for a world.
struct BuiltClouds {
  scene::Scene scene;
  std::optional<world::CloudSkyParameters> sky;  ///< with particles; none: the scene has no clouds
  /// Where the scene names other pictures than the one that was taken before.
  std::optional<clouds::BillboardTextures> billboards;
};

/// What becomes of clouds that are being made when a newer edit comes.
enum class Haste {
  let_finish,  ///< they are finished and shown first, as while a slider is held
  interrupt    ///< they are given up
};

/// Makes the clouds of edited scenes on a thread and a device of its own, so that a window goes on meanwhile.
/// Only the newest scene waits for its turn. Nothing of OpenCL leaves the thread.
class CloudBuilder {
 public:
  /// Opens the device. `shown` is the scene that is shown already. Throws what ocl::Device::open() throws.
  CloudBuilder(const ocl::DeviceInfo& device, const scene::Scene& shown);
  CloudBuilder(const CloudBuilder&) = delete;
  CloudBuilder& operator=(const CloudBuilder&) = delete;
  /// Gives up what is being made and waits until it has noticed.
  ~CloudBuilder();

  /// Gives a sky its particles on the caller's thread; before the first begin() only. Throws what
  /// world::CloudGrower::grown() throws.
  world::CloudSkyParameters grow(world::CloudSkyParameters sky, const CancelToken& cancel,
                                 const std::function<void(world::CloudProgress)>& progress = {});

  void begin(const scene::Scene& scene, Haste haste);
  /// What is ready since the last call, if anything; the fault of a scene whose clouds could not be made.
  std::optional<std::variant<BuiltClouds, Error>> take();
  /// Waits until all that was begun has come to an end.
  void wait();

  /// How far the clouds are that are being made, or wait for it; nothing when none are.
  std::optional<world::CloudProgress> progress() const;

 private:
  void work();
  std::variant<BuiltClouds, Error> built(const scene::Scene& scene,
                                         std::optional<clouds::BillboardTextures>& billboards);

  world::CloudGrower grower_;
  scene::CloudShapes shapes_;
  std::pair<std::string, std::string> billboard_folders_;  // whose pictures were read last
  mutable std::mutex mutex_;                               // for what follows
  std::condition_variable changed_;
  std::optional<scene::Scene> waiting_;
  std::optional<std::variant<BuiltClouds, Error>> ready_;
  std::optional<clouds::BillboardTextures> ready_billboards_;
  world::CloudProgress progress_;
  CancelToken* running_ = nullptr;
  bool is_closing_ = false;
  std::thread thread_;
};

}  // namespace offing::present
