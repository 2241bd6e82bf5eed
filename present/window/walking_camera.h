#pragma once

#include <memory>
#include <optional>

#include <glm/vec2.hpp>

#include "host/base/camera.h"
#include "host/scene/model/view_scene.h"
#include "host/terrain/walk/walker.h"
#include "host/world/world_terrain.h"
#include "present/window/free_camera.h"

namespace offing::present {

/// A camera on foot: keys walk, with Shift they run, and the ground carries it (terrain::Walker). It stands
/// on the ground as it is drawn, relief between the posts included.
class WalkingCamera {
 public:
  /// Moves a camera by what was asked for in so much time; it stands on this ground even if nothing was. From
  /// wherever somebody else has put it, it goes on at rest. False, and the camera as it was, beyond the
  /// ground's edge.
  bool advance(const world::TerrainParameters& terrain, const terrain::ReliefSettings& relief,
               const scene::ViewScene& how, const CameraInput& input, double seconds, Camera& camera);

 private:
  void begin(const world::TerrainParameters& terrain, const terrain::WalkerParameters& parameters,
             glm::dvec2 place_m);

  std::shared_ptr<const HeightMap> map_;  // which the walker is on, or these:
  std::shared_ptr<const world::TerrainTiles> tiles_;
  glm::dvec2 origin_m_{0.0};  // of its first post
  terrain::TerrainPosts posts_;
  std::optional<terrain::Walker> walker_;
  glm::dvec3 eye_m_{0.0};  // where the camera was left
};

}  // namespace offing::present
