#pragma once

#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "host/base/work.h"
#include "host/scene/model/scene.h"
#include "host/world/world_terrain.h"

namespace offing::present {

/// Lakes of a scene, and what a world needs of them on this ground.
struct SceneLakes {
  std::vector<scene::LakeScene> lakes;
  world::TerrainParameters terrain;  ///< with these lakes

  std::optional<double> sea_level_m;  ///< of a sea that they lie above

  /// Whether they were filled on this ground, in this place.
  bool are_on(const world::TerrainParameters& ground) const;
};

/// Fills the lakes of a scene in the background, as a basin can be large.
class LakeFiller {
 public:
  ~LakeFiller() { stop(); }

  /// Fills the lakes of a scene on ground that may have those of `before` already. Stops an earlier filling.
  void begin(const scene::Scene& scene, std::vector<scene::LakeScene> before,
             const world::TerrainParameters& terrain);
  void stop();
  bool is_busy() const { return filling_.valid(); }
  /// Whether the lakes of this scene are those that begin() was asked for last.
  bool is_asked_for(const scene::Scene& scene, const world::TerrainParameters& ground) const;
  /// What begin() asked for, once all lakes are filled. Throws what scene::prepare_lakes() throws, and
  /// Error(out_of_memory).
  std::optional<SceneLakes> take();

 private:
  SceneLakes asked_;
  std::unique_ptr<CancelToken> cancel_;
  std::future<SceneLakes> filling_;
};

}  // namespace offing::present
