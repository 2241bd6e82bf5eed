#include "present/window/walking_camera.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "host/terrain/walk/relief_height.h"

namespace offing::present {
namespace {

constexpr double run_factor = 5.0, slow_factor = 0.2;
constexpr double fastest_mps = 1000.0;  // of a Walker
// After a pause of the window nobody has walked on.
constexpr double longest_frame_s = 0.25;

/// East and south.
glm::dvec2 wanted_velocity(const Camera& camera, const scene::ViewScene& how, const CameraInput& input) {
  Camera level = camera;
  level.pitch_rad = level.roll_rad = 0.0;
  const CameraBasis axes = basis(level);
  const glm::dvec2 along(input.move.x * axes.right.x + input.move.z * axes.forward.x,
                         input.move.x * axes.right.z + input.move.z * axes.forward.z);
  if (along == glm::dvec2(0.0)) return along;
  const double factor = (input.is_fast ? run_factor : 1.0) * (input.is_slow ? slow_factor : 1.0);
  return std::min(how.walking_mps * factor, fastest_mps) * glm::normalize(along);
}

bool are_equal(const terrain::WalkerParameters& a, const terrain::WalkerParameters& b) {
  return a.eye_height_m == b.eye_height_m && a.slope_limit_rad == b.slope_limit_rad &&
         a.gravity_mps2 == b.gravity_mps2;
}

}  // namespace

void WalkingCamera::begin(const world::TerrainParameters& terrain,
                          const terrain::WalkerParameters& parameters, glm::dvec2 place_m) {
  map_ = terrain.map;
  tiles_ = terrain.tiles;
  origin_m_ = {terrain.origin_x_m, terrain.origin_z_m};
  posts_ = terrain.posts();
  walker_.emplace(posts_, parameters);
  walker_->reset(place_m.x, place_m.y);
}

bool WalkingCamera::advance(const world::TerrainParameters& terrain, const terrain::ReliefSettings& relief,
                            const scene::ViewScene& how, const CameraInput& input, double seconds,
                            Camera& camera) {
  const glm::dvec2 origin_m(terrain.origin_x_m, terrain.origin_z_m);
  const bool goes_on = walker_ && map_ == terrain.map && tiles_ == terrain.tiles && origin_m_ == origin_m &&
                       eye_m_ == camera.eye_m && are_equal(walker_->parameters(), how.walker);
  if (!goes_on) {
    const glm::dvec2 place_m = glm::dvec2(camera.eye_m.x, camera.eye_m.z) - origin_m;
    if (!terrain::terrain_at(terrain.posts(), place_m.x, place_m.y)) return false;
    begin(terrain, how.walker, place_m);
  }
  walker_->advance_to(walker_->time_s() + std::min(seconds, longest_frame_s),
                      wanted_velocity(camera, how, input));
  const glm::dvec3 eye_m = walker_->state().eye_m;
  const double relief_m = terrain::relief_height_m(posts_, relief, eye_m.x, eye_m.z, eye_m);
  camera.eye_m = eye_m + glm::dvec3(origin_m.x, relief_m, origin_m.y);
  eye_m_ = camera.eye_m;
  return true;
}

}  // namespace offing::present
