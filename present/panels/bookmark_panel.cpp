#include "present/panels/bookmark_panel.h"

#include <algorithm>
#include <string>

#include <imgui.h>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/window/bookmarks.h"

namespace offing::present {
namespace {

void note(Edit edit, ViewState& state, PanelEdits& edits) {
  if (edit == Edit::refused) state.message = {.text = state.edit.fault, .is_fault = true};
  edits.scene = std::max(edits.scene, edit);
}

void draw_values(ViewState& state, std::size_t index, PanelEdits& edits) {
  if (!ImGui::TreeNodeEx("place and angles", ImGuiTreeNodeFlags_NoTreePushOnOpen)) return;
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (row.group != scene::ParameterGroup::bookmark || row.key == "bookmark.name") continue;
    note(parameter_widget(state.scene, row, state.edit, {index, 0}), state, edits);
  }
}

/// False once it is removed.
bool draw_bookmark(ViewState& state, std::size_t index, PanelEdits& edits) {
  Camera& camera = state.scene.view.camera;
  ImGui::TextDisabled("%zu", index + 1);
  ImGui::SameLine();
  if (ImGui::SmallButton("go there")) {
    state.message = {.text = go_to_bookmark(state.scene, index + 1, camera)};
    edits.is_camera_moved = true;
  }
  ImGui::SameLine();
  if (ImGui::SmallButton("set to this view")) {
    state.message = {.text = set_bookmark(state.scene, camera, index + 1)};
    note(Edit::done, state, edits);
  }
  ImGui::SameLine();
  const bool is_removed = ImGui::SmallButton("remove");
  const scene::Parameter& name = *scene::find_parameter("bookmark.name");
  note(parameter_widget(state.scene, name, state.edit, {index, 0}), state, edits);
  draw_values(state, index, edits);
  if (is_removed) {
    scene::remove_element(state.scene, *name.section, {index, 0});
    note(Edit::done, state, edits);
  }
  return !is_removed;
}

}  // namespace

void draw_bookmarks(ViewState& state, PanelEdits& edits) {
  for (std::size_t i = 0; i < state.scene.bookmarks.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool is_there = draw_bookmark(state, i, edits);
    ImGui::PopID();
    if (!is_there) break;
  }
  const std::size_t count = state.scene.bookmarks.size();
  ImGui::BeginDisabled(count >= scene::find_parameter("bookmark.name")->max_count);
  if (ImGui::Button("add this view##Bookmarks")) {
    set_bookmark(state.scene, state.scene.view.camera, count + 1);
    note(Edit::done, state, edits);
  }
  ImGui::EndDisabled();
}

}  // namespace offing::present
