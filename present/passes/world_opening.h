#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "host/base/work.h"
#include "host/ocl/device.h"
#include "host/scene/model/scene.h"
#include "host/world/world.h"
#include "present/editing/cloud_builder.h"
#include "present/passes/quality.h"

namespace offing::present {

/// What is being done for a world that somebody waits for.
struct OpeningStep {
  std::string work;             ///< "the clouds"
  std::optional<double> share;  ///< of it that is done, where that is known
};

/// Whether a scene's first picture has its clouds.
enum class FirstClouds {
  at_once,
  later,  ///< only if the rest stands without them: somebody makes them by the builder afterwards
};

/// What the first picture of a world shows, and how.
struct FirstView {
  double time_s = 0.0;
  Quality quality = {};
  FirstClouds clouds = FirstClouds::at_once;
};

/// A scene's world, with what goes with it.
struct OpenedWorld {
  scene::Scene scene;                            ///< as it is shown, its camera placed
  std::optional<scene::Scene> with_clouds = {};  ///< where clouds come later: the whole scene
  std::unique_ptr<CloudBuilder> builder;
  std::unique_ptr<world::World> world;
};

/// Takes a world to a view, as coarse as its quality says.
void show_view(world::World& world, const FirstView& view, const glm::dvec3& eye_m);

/// Makes a scene's world on a thread of its own and takes it to its first picture, so that a window can show
/// how far it is and make its passes meanwhile. The device's queue is the thread's until take().
class WorldOpening {
 public:
  /// `view`: absent for the scene's start. The token, which may be null, outlives this.
  WorldOpening(const ocl::Device& device, const scene::Scene& scene, std::optional<FirstView> view,
               const CancelToken* cancel);
  WorldOpening(const WorldOpening&) = delete;
  WorldOpening& operator=(const WorldOpening&) = delete;

  OpeningStep step() const;
  /// Waits for the world, but no longer than this; whether there is one, or a fault.
  bool wait_for(std::chrono::milliseconds time) const;
  /// Waits for the world. Throws what preparing and making it throws, Error(cancelled) where the token says
  /// so.
  OpenedWorld take() { return world_.get(); }

 private:
  OpenedWorld open(const ocl::Device& device, scene::Scene scene, std::optional<FirstView> view,
                   const CancelToken& cancel);
  void begin(const char* work);

  mutable std::mutex mutex_;
  OpeningStep step_;
  std::future<OpenedWorld> world_;  // last: it waits for the thread, which uses the others
};

}  // namespace offing::present
