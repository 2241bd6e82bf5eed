#include "host/cli/terrain_camera.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "host/base/argument.h"
#include "host/cli/number_list.h"
#include "host/terrain/flying_camera.h"
#include "host/terrain/ground.h"

namespace offing::cli {
namespace {

constexpr double radians = std::numbers::pi / 180.0;
constexpr double eye_height_m = 1.7;

}  // namespace

Camera read_terrain_camera(std::string_view text, const HeightMap& map) {
  Camera camera;
  if (text == "fly") {
    camera = terrain::flying_camera(map);
  } else if (text == "walk") {
    const double x_m = 0.5 * map.spacing_x_m * (map.columns - 1),
                 z_m = 0.5 * map.spacing_z_m * (map.rows - 1);
    const terrain::GroundPoint ground = *terrain::ground_at(map, x_m, z_m);
    camera.eye_m = {x_m, ground.height_m + eye_height_m, z_m};
    // Level ground has no way down: north.
    camera.yaw_rad = std::atan2(ground.normal.x, -ground.normal.z);
  } else {
    const std::vector<double> place =
        read_numbers("--camera", text, 5, "fly, walk or X,Y,Z,YAW_DEG,PITCH_DEG", "500,300,900,0,-15");
    if (std::abs(place[4]) > 90.0) {
      throw bad_argument("--camera", "a pitch within [-90, 90] degrees", text, "500,300,900,0,-15");
    }
    camera.eye_m = {place[0], place[1], place[2]};
    camera.yaw_rad = std::remainder(place[3], 360.0) * radians;
    camera.pitch_rad = place[4] * radians;
  }
  return camera;
}

}  // namespace offing::cli
