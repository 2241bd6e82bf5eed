#include "present/editing/scene_editing.h"

#include <utility>

#include "present/editing/cloud_overlay.h"
#include "present/output/camera_path.h"

namespace offing::present {

void SceneEditing::begin_anew(SceneHistory history) {
  highlights_ = {};
  clouds_ = {};
  history_ = std::move(history);
  is_last_noted_ = true;
}

SceneHistory SceneEditing::history() const {
  SceneHistory history = history_;
  if (!is_last_noted_) history.note(state_.scene);
  return history;
}

bool SceneEditing::turn(const Screen& screen, const std::vector<PointerEvent>& events,
                        const PointerNow& pointer) {
  const bool edits_clouds =
      state_.clouds.pick != CloudPick::none || state_.clouds.tool != CloudTool::pick || clouds_.holds();
  work([&] {
    return edits_clouds ? clouds_.turn(state_, sea_.clouds(), screen, events, pointer)
                        : highlights_.turn(state_, sea_.meshes(), screen, events, pointer.clip);
  });
  return edits_clouds ? clouds_.holds() : highlights_.holds();
}

void SceneEditing::work(const std::function<Edit()>& deed) {
  try {
    apply(deed());
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
}

void SceneEditing::make(const std::function<std::string(scene::Scene&)>& deed) {
  work([&] {
    scene::Scene edited = state_.scene;
    std::string news = deed(edited);
    state_.scene = std::move(edited);
    finish(Edit::done);
    if (state_.message.is_fault) return Edit::none;
    if (!state_.message.text.empty()) news += '\n' + state_.message.text;
    state_.message = {.text = std::move(news)};
    return Edit::none;
  });
}

void SceneEditing::finish(Edit edit) {
  if (edit != Edit::none) clouds_.let_go();
  apply(edit);
}

void SceneEditing::apply(Edit edit) {
  if (edit == Edit::none) return;
  if (!edit_sea(edit)) return;
  is_last_noted_ = edit == Edit::done;
  if (is_last_noted_) history_.note(state_.scene);
}

bool SceneEditing::edit_sea(Edit edit) {
  try {
    sea_.begin_edit(state_.scene, edit == Edit::going_on ? Haste::let_finish : Haste::interrupt);
    state_.pick.reset();  // the ground may be another one
    if (edit != Edit::refused) state_.message = {.text = sea_.warning()};
    return true;
  } catch (const Error& error) {
    state_.message = fault_message(error);
    // So that letting go of a slider there is not an edit that is done, which would clear the message.
    if (edit == Edit::going_on) state_.edit.fault = state_.message.text;
    take_scene(sea_.wanted());
    return false;
  }
}

void SceneEditing::take_scene(scene::Scene scene) {
  clouds_.let_go();  // of what it held there may be nothing any more
  take_camera_path(state_.scene, scene);
  scene.view.camera = state_.scene.view.camera;
  state_.scene = std::move(scene);
  forget_lost_picks(state_);
}

void SceneEditing::take_clouds() {
  try {
    sea_.take_clouds();
  } catch (const Error& error) {
    const Message fault = fault_message(error);
    // What failed is taken back. What is the last edit then may still have to be made, as it was given up for
    // the one that failed.
    if (is_last_noted_) history_.take_back();
    // As where the world refuses a value at once: a slider that is held is not to clear the message.
    if (!is_last_noted_) state_.edit.fault = fault.text;
    is_last_noted_ = true;
    take_scene(history_.now());
    edit_sea(Edit::refused);
    state_.message = fault;
  }
}

void SceneEditing::go_back(std::optional<scene::Scene> scene, const char* none) {
  if (!scene) {
    state_.message = {.text = none};
    return;
  }
  take_scene(std::move(*scene));
  state_.clouds.particles = {};
  is_last_noted_ = true;
  edit_sea(Edit::done);
}

void SceneEditing::undo() {
  go_back(history_.undo(), "there is nothing to undo");
}

void SceneEditing::redo() {
  go_back(history_.redo(), "there is nothing to redo");
}

bool SceneEditing::deselect() {
  if (highlights_.holds() || clouds_.holds()) return true;
  CloudEditing& clouds = state_.clouds;
  const bool has_any = state_.pick || state_.picked || clouds.tool != CloudTool::pick ||
                       !clouds.picked.empty() || !clouds.particles.empty();
  state_.pick.reset();
  state_.picked.reset();
  clouds.tool = CloudTool::pick;
  clouds.forget_picks();
  return has_any;
}

void SceneEditing::next_cloud_pick() {
  const auto next = (static_cast<std::size_t>(state_.clouds.pick) + 1) % cloud_pick_names.size();
  state_.clouds.pick = static_cast<CloudPick>(next);
  state_.clouds.forget_picks();
  state_.message = {.text = std::string("clicks on clouds pick ") + cloud_pick_names[next]};
}

void SceneEditing::toggle_tool(CloudTool tool) {
  CloudEditing& clouds = state_.clouds;
  clouds.tool = clouds.tool == tool ? CloudTool::pick : tool;
  switch (clouds.tool) {
    case CloudTool::pick:
      state_.message = {.text = "clicks pick again"};
      break;
    case CloudTool::place_ball:
      state_.message = {.text = "clicks place balls, at the height of what is picked"};
      break;
    case CloudTool::place_cloud:
      state_.message = {.text = "clicks place clouds, at the height of what is picked or of their genus"};
      break;
  }
}

void SceneEditing::remove_picked() {
  work([&] { return clouds_.remove(state_); });
}

void SceneEditing::duplicate_picked() {
  work([&] { return clouds_.duplicate(state_, sea_.clouds()); });
}

void SceneEditing::draw(glm::dvec2 pointer) const {
  if (state_.picked) draw_highlight_handles(*state_.picked, sea_.meshes(), state_.camera.camera());
  draw_cloud_overlay(state_, sea_.clouds(), clouds_.box(pointer));
}

}  // namespace offing::present
