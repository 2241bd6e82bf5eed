#include "host/terrain/flying_camera.h"

#include <algorithm>
#include <numbers>

namespace offing::terrain {

Camera flying_camera(const HeightMap& map) {
  constexpr double height_m = 300.0, pitch_rad = -15.0 / 180.0 * std::numbers::pi;
  const float highest_m = *std::max_element(map.heights_m.begin(), map.heights_m.end());
  Camera camera;
  camera.eye_m = {0.5 * map.spacing_x_m * (map.columns - 1), highest_m + height_m,
                  map.spacing_z_m * (map.rows - 1)};
  camera.pitch_rad = pitch_rad;
  return camera;
}

}  // namespace offing::terrain
