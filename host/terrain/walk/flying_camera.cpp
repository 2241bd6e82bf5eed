#include "host/terrain/walk/flying_camera.h"

#include <numbers>

namespace offing::terrain {

Camera flying_camera(const TerrainExtent& extent) {
  constexpr double height_m = 300.0, pitch_rad = -15.0 / 180.0 * std::numbers::pi;
  Camera camera;
  camera.eye_m = {0.5 * extent.width_m, extent.highest_m + height_m, extent.depth_m};
  camera.pitch_rad = pitch_rad;
  return camera;
}

}  // namespace offing::terrain
