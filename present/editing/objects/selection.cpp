#include "present/editing/objects/selection.h"

namespace offing::present {

std::optional<SceneObject> selected_object(const ViewState& state) {
  std::optional<SceneObject> object = state.object;
  const CloudEditing& clouds = state.clouds;
  if (!clouds.picked.empty()) {
    object = SceneObject{ObjectKind::cloud, clouds.picked.back().cloud};
  } else if (!clouds.particles.empty()) {
    object = SceneObject{ObjectKind::cloud, clouds.particles.clouds.front().cloud};
  } else if (state.picked) {
    object = SceneObject{ObjectKind::mesh, state.picked->mesh};
  }
  return object && has_object(state.scene, *object) ? object : std::nullopt;
}

void select_object(ViewState& state, const SceneObject& object) {
  deselect_objects(state);
  state.clouds.tool = CloudTool::pick;
  state.clouds.pick = object.kind == ObjectKind::cloud ? CloudPick::clouds : CloudPick::none;
  if (object.kind == ObjectKind::cloud) {
    state.clouds.picked = {{object.index, {}}};
  } else {
    state.object = object;
  }
}

bool deselect_objects(ViewState& state) {
  const bool had_any =
      state.object || state.picked || !state.clouds.picked.empty() || !state.clouds.particles.empty();
  state.object.reset();
  state.picked.reset();
  state.clouds.forget_picks();
  return had_any;
}

}  // namespace offing::present
