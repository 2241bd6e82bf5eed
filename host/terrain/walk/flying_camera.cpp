#include "host/terrain/walk/flying_camera.h"

#include <algorithm>
#include <numbers>

namespace offing::terrain {

TerrainExtent extent_of(const HeightMap& map) {
  return {.width_m = map.spacing_x_m * (map.columns - 1),
          .depth_m = map.spacing_z_m * (map.rows - 1),
          .highest_m = *std::max_element(map.heights_m.begin(), map.heights_m.end())};
}

Camera flying_camera(const TerrainExtent& extent) {
  constexpr double height_m = 300.0, pitch_rad = -15.0 / 180.0 * std::numbers::pi;
  Camera camera;
  camera.eye_m = {0.5 * extent.width_m, extent.highest_m + height_m, extent.depth_m};
  camera.pitch_rad = pitch_rad;
  return camera;
}

}  // namespace offing::terrain
