#include "host/cli/terrain/terrain_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <spdlog/spdlog.h>

#include "host/base/argument.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/walk/eye_place.h"
#include "host/terrain/walk/flying_camera.h"

namespace offing::cli {
namespace {

constexpr double eye_height_m = 1.7;

}  // namespace

CameraTerrain camera_terrain(const HeightMap& map) {
  return {.extent = terrain::extent_of(map),
          .under = [&map](double x_m, double z_m) { return *terrain::terrain_at(map, x_m, z_m); }};
}

CameraTerrain camera_terrain(terrain::TiledField& field) {
  const terrain::TiledMap& map = field.map();
  return {.extent = {.width_m = map.width_m(), .depth_m = map.depth_m(), .highest_m = map.highest_m},
          .under =
              [&field](double x_m, double z_m) {
                // With the eye there, the tile is of the finest level.
                const double above_m = field.map().highest_m + 1.0;
                field.look_and_wait({.eye_m = {x_m, field.map().lowest_m, z_m}});
                const terrain::RayHit hit =
                    field.cast(std::vector{terrain::Ray{.origin_m = {x_m, above_m, z_m}}}).front();
                return terrain::TerrainPoint{above_m - hit.distance_m,
                                             {hit.normal_x, hit.normal_y, hit.normal_z}};
              },
          .ends = map.edge == terrain::MapEdge::ends};
}

Camera read_terrain_camera(std::string_view text, const CameraTerrain& terrain) {
  Camera camera;
  if (text == "fly") {
    camera = terrain::flying_camera(terrain.extent);
  } else if (text == "walk") {
    const double x_m = 0.5 * terrain.extent.width_m, z_m = 0.5 * terrain.extent.depth_m;
    const terrain::TerrainPoint below = terrain.under(x_m, z_m);
    camera.eye_m = {x_m, below.height_m + eye_height_m, z_m};
    // Level ground has no way down: north.
    camera.yaw_rad = std::atan2(below.normal.x, -below.normal.z);
  } else {
    const bool is_local = !terrain.on_map;
    const std::vector<double> place = read_numbers(
        "--camera", text, 5,
        is_local ? "fly, walk or X,Y,Z,YAW_DEG,PITCH_DEG" : "fly, walk or X,Y,HEIGHT,YAW_DEG,PITCH_DEG",
        is_local ? "500,300,900,0,-15" : "-70.5,-32.5,5000,0,-15");
    if (std::abs(place[4]) > 90.0) {
      throw bad_argument("--camera", "a pitch within [-90, 90] degrees", text, "500,300,900,0,-15");
    }
    if (is_local) {
      camera.eye_m = {place[0], place[1], place[2]};
    } else {
      const glm::dvec2 plan_m = terrain.on_map({place[0], place[1]});
      camera.eye_m = {plan_m.x, place[2], plan_m.y};
    }
    camera.yaw_rad = std::remainder(place[3], 360.0) * radians_per_degree;
    camera.pitch_rad = place[4] * radians_per_degree;
  }
  return camera;
}

void keep_above_ground(Camera& camera, const CameraTerrain& terrain) {
  if (terrain.ends) {
    if (const auto warning = terrain::warning_off_map(camera.eye_m, terrain.extent)) {
      spdlog::warn("{}", *warning);
      return;
    }
  }
  if (camera.eye_m.y > terrain.extent.highest_m) return;
  double x_m = camera.eye_m.x, z_m = camera.eye_m.z;
  if (terrain.ends) {
    // An eye on the edge may be beyond it by rounding.
    x_m = std::clamp(x_m, 0.0, terrain.extent.width_m);
    z_m = std::clamp(z_m, 0.0, terrain.extent.depth_m);
  }
  const double terrain_m = terrain.under(x_m, z_m).height_m;
  const auto warning = terrain::lift_out_of_terrain(camera.eye_m, terrain_m, eye_height_m);
  if (warning) spdlog::warn("{}", *warning);
}

void read_image_size(std::string_view text, Camera& camera) {
  constexpr int most_px = 16384;
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) throw bad_argument("--size", "WIDTHxHEIGHT", text, "1280x720");
  camera.width_px = static_cast<int>(read_whole("--size", text.substr(0, cross), 1, most_px, "1280x720"));
  camera.height_px = static_cast<int>(read_whole("--size", text.substr(cross + 1), 1, most_px, "1280x720"));
}

}  // namespace offing::cli
