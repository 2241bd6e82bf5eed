#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "host/base/camera.h"
#include "host/world/world_terrain.h"
#include "present/gl/gl_objects.h"
#include "present/panels/panel_layout.h"

namespace offing::present {

/// The ground from above, lit from the north-west as maps are, with the sea in blue,
/// the camera's place and what it looks at.
class MiniMap {
 public:
  /// The picture of a ground and of the sea on it, if there is one, unless it is there. At most 256 pixels a
  /// side, north up.
  void show(const world::TerrainParameters& terrain, std::optional<double> sea_level_m);
  /// Draws it as an ImGui window at the bottom right, with the camera; where on the ground it was clicked,
  /// east and south of the origin, if it was.
  std::optional<glm::dvec2> draw(const Camera& camera, PanelLayout& layout) const;

  /// Pixels [height][width][3] of the picture, row 0 in the north.
  static std::vector<unsigned char> shaded(const HeightMap& map, std::optional<double> sea_level_m, int width,
                                           int height);

 private:
  std::shared_ptr<const HeightMap> map_;  ///< of the picture
  std::shared_ptr<const world::TerrainTiles> tiles_;
  std::optional<double> sea_level_m_;
  glm::dvec2 origin_m_{0.0}, size_m_{1.0};
  int width_px_ = 0, height_px_ = 0;
  GlTexture texture_;
};

}  // namespace offing::present
