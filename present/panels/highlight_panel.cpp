#include "present/panels/highlight_panel.h"

#include <algorithm>
#include <string>
#include <utility>

#include <imgui.h>

#include "host/scene/schema/parameter_table.h"
#include "present/editing/highlight_edits.h"

namespace offing::present {
namespace {

using highlights::DrawnHighlight;

/// A scene of this highlight alone, at this time: what the widgets change.
scene::Scene moment_of(const ViewState& state, const DrawnHighlight& drawn) {
  scene::Scene copy;
  copy.lights = state.scene.lights;
  copy.meshes = {state.scene.meshes[state.picked->mesh]};
  const scene::ElementIndex element = controls_of(copy, {}, drawn);
  scene::HighlightScene highlight = std::move(copy.meshes[0].highlights[element.inner]);
  const int picture = highlight.rule.controls.picture;
  highlight.rule.controls = drawn.controls;
  highlight.rule.controls.picture = picture;
  copy.meshes[0].highlights = {std::move(highlight)};
  return copy;
}

void store_moment(ViewState& state, const DrawnHighlight& drawn, scene::HighlightScene edited) {
  const scene::ElementIndex element = controls_of(state.scene, *state.picked, drawn);
  scene::HighlightScene& stored = state.scene.meshes[element.outer].highlights[element.inner];
  const highlights::HighlightControls controls = std::exchange(edited.rule.controls, stored.rule.controls);
  stored = std::move(edited);
  store_controls(state.scene, element, controls, state.clock.time_s());
}

Edit draw_rows(ViewState& state, const DrawnHighlight& drawn) {
  scene::Scene moment = moment_of(state, drawn);
  Edit edit = Edit::none;
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (row.group == scene::ParameterGroup::highlight)
      edit = std::max(edit, parameter_widget(moment, row, state.edit));
  }
  if (edit == Edit::refused) state.message = {.text = state.edit.fault, .is_fault = true};
  if (edit != Edit::none) store_moment(state, drawn, std::move(moment.meshes[0].highlights[0]));
  return edit;
}

Edit draw_key_buttons(ViewState& state, const DrawnHighlight& drawn) {
  Edit edit = Edit::none;
  if (ImGui::Button("set keyframes")) {
    store_keys(state.scene, controls_of(state.scene, *state.picked, drawn), drawn.controls,
               state.clock.time_s());
    edit = Edit::done;
  }
  if (drawn.rule < 0) return edit;
  const scene::ElementIndex element{state.picked->mesh, static_cast<std::size_t>(drawn.rule)};
  if (!has_keys(state.scene, element)) return edit;
  ImGui::SameLine();
  if (ImGui::Button("remove keyframes")) {
    remove_keys(state.scene, element, drawn.controls);
    edit = Edit::done;
  }
  return edit;
}

}  // namespace

Edit draw_highlight_panel(ViewState& state, const std::vector<world::WorldMesh>& meshes) {
  const DrawnHighlight* drawn = picked_highlight(state.scene, meshes, state.picked);
  if (drawn == nullptr) return Edit::none;
  state.layout.place_right();
  ImGui::Begin("Highlight", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushItemWidth(side_item_em * ImGui::GetFontSize());
  const scene::MeshScene& mesh = state.scene.meshes[state.picked->mesh];
  ImGui::PushTextWrapPos(side_text_em * ImGui::GetFontSize());
  if (drawn->rule < 0) {
    ImGui::TextDisabled("of %s, where the lights put it; an edit makes it a highlight of its own",
                        mesh.name.c_str());
  } else {
    ImGui::TextDisabled("of %s, number %d of its own highlights", mesh.name.c_str(), drawn->rule + 1);
  }
  ImGui::PopTextWrapPos();
  const Edit keys = draw_key_buttons(state, *drawn);
  const Edit edit = std::max(keys, draw_rows(state, *drawn));
  ImGui::PopItemWidth();
  state.layout.end_right();
  ImGui::End();
  return edit;
}

}  // namespace offing::present
