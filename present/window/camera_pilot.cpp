#include "present/window/camera_pilot.h"

#include <algorithm>
#include <optional>

#include "present/editing/terrain_pick.h"

namespace offing::present {

using scene::CameraMode;

void CameraPilot::move(ViewState& state, LiveSea& sea, const CameraInput& input, double seconds) {
  FreeCamera& camera = state.camera;
  camera.set_water_level(sea.sea_level_m());
  const auto surface_m = [&sea](double x_m, double z_m) { return sea.surface_height_m(x_m, z_m); };
  scene::ViewScene& view = state.scene.view;
  if (view.mode == CameraMode::walk && sea.terrain()) {
    camera.look(input);
    if (walking_.advance(sea.terrain()->parameters(), sea.terrain()->relief_settings(), view, input, seconds,
                         camera.camera())) {
      const glm::dvec3& eye_m = camera.camera().eye_m;
      if (sea.scene().has_sea() || !sea.scene().lakes.empty()) camera.rise_above(surface_m(eye_m.x, eye_m.z));
      return;
    }
    view.mode = CameraMode::fly;
    state.message = {.text = "there is no ground here to walk on"};
  }
  camera.advance(input, seconds, surface_m);
  if (!sea.terrain()) return;
  const glm::dvec3& eye_m = camera.camera().eye_m;
  const std::optional<double> below_m = sea.terrain()->surface_m(eye_m.x, eye_m.z);
  if (below_m && *below_m > eye_m.y) camera.rise_above(*below_m);
}

bool CameraPilot::toggle_walk(ViewState& state, LiveSea& sea) const {
  if (!sea.terrain()) {
    state.message = {.text = "there is no ground in this scene to walk on"};
    return false;
  }
  CameraMode& mode = state.scene.view.mode;
  mode = mode == CameraMode::walk ? CameraMode::fly : CameraMode::walk;
  return true;
}

bool CameraPilot::go_to(ViewState& state, LiveSea& sea, glm::dvec2 place_m) const {
  if (!sea.terrain()) return false;
  const std::optional<double> terrain_m = sea.terrain()->surface_m(place_m.x, place_m.y);
  if (!terrain_m) return false;
  // Where the sea covers the ground, above the sea.
  const double surface_m = sea.scene().has_sea() ? std::max(*terrain_m, sea.sea_level_m()) : *terrain_m;
  state.camera.camera().eye_m = {place_m.x, surface_m + state.scene.view.walker.eye_height_m, place_m.y};
  return true;
}

bool CameraPilot::go_through(ViewState& state, LiveSea& sea, glm::dvec2 clip) const {
  if (!sea.terrain() || !sea.terrain()->is_in_reach()) return false;
  const std::optional<TerrainPick> pick = pick_terrain(*sea.terrain(), state.camera.camera(), clip);
  return pick && go_to(state, sea, {pick->place_m.x, pick->place_m.z});
}

}  // namespace offing::present
