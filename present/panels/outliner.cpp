#include "present/panels/outliner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "host/clouds/shape/genera.h"
#include "host/mesh_shapes/shape_table.h"
#include "host/scene/schema/parameter_table.h"
#include "present/editing/objects/selection.h"
#include "present/panels/preset_buttons.h"
#include "present/window/bookmarks.h"

namespace offing::present {
namespace {

ImU32 colour_of(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::camera:
    case ObjectKind::bookmark:
      return IM_COL32(190, 150, 230, 255);
    case ObjectKind::sky:
    case ObjectKind::light:
      return IM_COL32(250, 210, 90, 255);
    case ObjectKind::sea:
    case ObjectKind::wake:
    case ObjectKind::lake:
      return IM_COL32(80, 160, 230, 255);
    case ObjectKind::terrain:
      return IM_COL32(120, 180, 90, 255);
    case ObjectKind::cloud_layer:
    case ObjectKind::cloud:
      return IM_COL32(210, 215, 220, 255);
    case ObjectKind::mesh:
    case ObjectKind::body:
      return IM_COL32(235, 140, 70, 255);
  }
  return 0;
}

/// How far an object stands below what it belongs to.
float depth_of(const scene::Scene& scene, const SceneObject& object) {
  const bool is_nested = object.kind == ObjectKind::wake || object.kind == ObjectKind::bookmark ||
                         (object.kind == ObjectKind::body && hull_of_body(scene, object.index).has_value());
  return is_nested ? 1.0f : 0.0f;
}

std::optional<NewObject> draw_genera(const char* label, NewObject::Kind kind) {
  std::optional<NewObject> chosen;
  if (!ImGui::BeginMenu(label)) return chosen;
  for (const clouds::Genus genus : clouds::all_genera) {
    if (ImGui::MenuItem(std::string(clouds::range_of(genus).name).c_str()))
      chosen = NewObject{.kind = kind, .genus = genus};
  }
  ImGui::EndMenu();
  return chosen;
}

std::optional<NewObject> draw_menu(const scene::Scene& scene) {
  using enum NewObject::Kind;
  std::optional<NewObject> chosen;
  const auto item = [&](const char* label, NewObject::Kind kind, bool is_possible) {
    if (ImGui::MenuItem(label, nullptr, false, is_possible)) chosen = NewObject{.kind = kind};
  };
  item("boat", boat, scene.has_sea());
  if (ImGui::BeginMenu("mesh")) {
    const auto& shapes = mesh_shapes::shapes();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (ImGui::MenuItem(std::string(shapes[i].name).c_str())) chosen = NewObject{.kind = mesh, .shape = i};
    }
    ImGui::EndMenu();
  }
  item("light", light, true);
  if (const auto genus = draw_genera("cloud", cloud)) chosen = genus;
  if (const auto genus = draw_genera("cloud layer", cloud_layer)) chosen = genus;
  item("sea", sea, !scene.has_sea());
  item("terrain", terrain, !scene.terrain.is_given);
  item("lake", lake, scene.terrain.is_given);
  item("bookmark of this view", bookmark, true);
  return chosen;
}

/// All but the first do what their keys do: also where a part of the object is picked.
void draw_buttons(ViewState& state, PanelEdits& edits) {
  const std::optional<SceneObject> selected = selected_object(state);
  if (ImGui::Button("add##objects")) ImGui::OpenPopup("new object");
  if (ImGui::BeginPopup("new object")) {
    if (const std::optional<NewObject> chosen = draw_menu(state.scene))
      edits.object = ObjectEdit{.kind = ObjectEdit::Kind::add, .added = *chosen};
    ImGui::EndPopup();
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(!selected || !can_be_duplicated(*selected));
  if (ImGui::Button("duplicate##objects")) edits.action = ViewAction::duplicate_picked;
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!selected || !can_be_removed(state.scene, *selected));
  if (ImGui::Button("delete##objects")) edits.action = ViewAction::remove_picked;
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!selected);
  if (ImGui::Button("look at##objects")) edits.action = ViewAction::look_at_selected;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("X");
  ImGui::EndDisabled();
}

/// In the place of a row: Enter takes the name, Esc and a click elsewhere leave the one before.
void draw_name_field(ViewState& state, PanelEdits& edits) {
  Renaming& renaming = *state.renaming;
  ImGui::SetNextItemWidth(-1.0f);
  if (renaming.is_new) ImGui::SetKeyboardFocusHere();
  const bool is_entered = ImGui::InputText(
      "##new name", &renaming.text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool is_left = !renaming.is_new && ImGui::IsItemDeactivated();
  renaming.is_new = false;
  if (is_entered) {
    edits.object =
        ObjectEdit{.kind = ObjectEdit::Kind::rename, .object = renaming.object, .name = renaming.text};
  }
  if (is_entered || is_left) state.renaming.reset();
}

void open_row(ViewState& state, const SceneObject& object, PanelEdits& edits) {
  if (object.kind == ObjectKind::bookmark) {
    state.message = {.text = go_to_bookmark(state.scene, object.index + 1, state.scene.view.camera)};
    edits.is_camera_moved = true;
  } else if (name_row(object.kind) != nullptr) {
    const std::string label = label_of(state.scene, object);
    state.renaming = Renaming{.object = object, .text = label, .is_new = true};
  }
}

constexpr float eye_ems = 1.6f;

/// At the end of a row: an eye that is open, or a line where the mesh is hidden.
void draw_eye(ViewState& state, std::size_t mesh, PanelEdits& edits) {
  const float em = ImGui::GetFontSize();
  world::MeshVisibility& visible = state.scene.meshes[mesh].material.visible;
  const bool is_shown = visible == world::MeshVisibility::on;
  ImGui::SameLine(0.0f, 0.0f);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##visible", {eye_ems * em, ImGui::GetTextLineHeight()})) {
    visible = is_shown ? world::MeshVisibility::off : world::MeshVisibility::on;
    edits.scene = Edit::done;
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip(is_shown ? "hide" : "show");
  const ImVec2 middle(corner.x + 0.5f * eye_ems * em, corner.y + 0.5f * ImGui::GetTextLineHeight());
  const ImU32 colour = ImGui::GetColorU32(is_shown ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!is_shown) {
    list.AddLine({middle.x - 0.5f * em, middle.y}, {middle.x + 0.5f * em, middle.y}, colour, 1.5f);
    return;
  }
  // Two arcs of 90 degrees that meet in the corners.
  constexpr float quarter = 1.5707963f;
  const float radius = 0.71f * em, rise = 0.5f * em;
  list.PathArcTo({middle.x, middle.y + rise}, radius, -1.5f * quarter, -0.5f * quarter, 8);
  list.PathArcTo({middle.x, middle.y - rise}, radius, 0.5f * quarter, 1.5f * quarter, 8);
  list.PathStroke(colour, ImDrawFlags_Closed, 1.2f);
  list.AddCircleFilled(middle, 0.15f * em, colour);
}

/// How a row is shown.
enum class RowShow { plain, selected, newly_selected };

void draw_row(ViewState& state, const SceneObject& object, RowShow show, PanelEdits& edits) {
  const bool is_selected = show != RowShow::plain;
  const float em = ImGui::GetFontSize(), indent = (0.2f + depth_of(state.scene, object)) * em;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (state.renaming && state.renaming->object == object) return draw_name_field(state, edits);
  const bool has_eye = object.kind == ObjectKind::mesh;
  const ImVec2 size(ImGui::GetContentRegionAvail().x - (has_eye ? eye_ems * em : 0.0f), 0.0f);
  if (ImGui::Selectable("##object", is_selected, ImGuiSelectableFlags_AllowDoubleClick, size)) {
    if (!is_selected) select_object(state, object);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) open_row(state, object, edits);
  }
  const float top = ImGui::GetWindowPos().y, end = top + ImGui::GetWindowHeight();
  const bool is_whole = ImGui::GetItemRectMin().y >= top && ImGui::GetItemRectMax().y <= end;
  if (show == RowShow::newly_selected && !is_whole) ImGui::SetScrollHereY();
  // Names can hold what ImGui takes for the end of a label: they are text beside a row without one.
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = corner.y + 0.5f * ImGui::GetTextLineHeight();
  list.AddCircleFilled({corner.x + indent + 0.4f * em, middle}, 0.28f * em, colour_of(object.kind));
  list.AddText({corner.x + indent + 1.1f * em, corner.y}, ImGui::GetColorU32(ImGuiCol_Text),
               label_of(state.scene, object).c_str());
  if (has_eye) draw_eye(state, object.index, edits);
}

void draw_list(ViewState& state, PanelEdits& edits) {
  // There is to be room for the values below the list.
  constexpr float least_rows = 4.0f, most_rows = 12.0f, most_share = 0.4f;
  const float room = most_share * state.layout.main_room() / ImGui::GetTextLineHeightWithSpacing() - 1.0f;
  const std::vector<SceneObject> objects = objects_of(state.scene);
  const std::optional<SceneObject> selected = selected_object(state);
  const float rows =
      std::min(static_cast<float>(objects.size()), std::clamp(std::floor(room), least_rows, most_rows));
  const float height_px =
      rows * ImGui::GetTextLineHeightWithSpacing() + 2.0f * ImGui::GetStyle().WindowPadding.y;
  ImGui::BeginChild("objects", ImVec2(0.0f, height_px), true);
  for (const SceneObject& object : objects) {
    // Where a list changes while one of its rows is open, the row is gone.
    ImGui::PushID(static_cast<int>(object.kind));
    ImGui::PushID(static_cast<int>(object.index));
    const RowShow show = selected == state.listed ? RowShow::selected : RowShow::newly_selected;
    draw_row(state, object, object == selected ? show : RowShow::plain, edits);
    ImGui::PopID();
    ImGui::PopID();
  }
  ImGui::EndChild();
  state.listed = selected;
  if (state.renaming && !has_object(state.scene, state.renaming->object)) state.renaming.reset();
}

void note_edit(Edit edit, scene::ParameterGroup group, ViewState& state, PanelEdits& edits) {
  if (edit == Edit::refused) state.message = {.text = state.edit.fault, .is_fault = true};
  if (group == scene::ParameterGroup::camera) {
    edits.is_camera_moved = edits.is_camera_moved || edit != Edit::none;
  } else {
    edits.scene = std::max(edits.scene, edit);
  }
}

void draw_view_buttons(ViewState& state, std::size_t bookmark, PanelEdits& edits) {
  if (ImGui::Button("look through")) {
    state.message = {.text = go_to_bookmark(state.scene, bookmark + 1, state.scene.view.camera)};
    edits.is_camera_moved = true;
  }
  ImGui::SameLine();
  if (ImGui::Button("place here")) {
    state.message = {.text = set_bookmark(state.scene, state.scene.view.camera, bookmark + 1)};
    edits.scene = Edit::done;
  }
}

/// The values of an object but for its name, which the list changes.
void draw_properties(ViewState& state, const SceneObject& object, PanelEdits& edits) {
  const bool is_body = object.kind == ObjectKind::body;
  const std::string title =
      fmt::format("{}###{}", label_of(state.scene, object), is_body ? "body" : "properties");
  if (!ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
  ImGui::PushID("properties");
  if (object.kind == ObjectKind::bookmark) draw_view_buttons(state, object.index, edits);
  if (object.kind == ObjectKind::camera)
    ImGui::TextDisabled("Fly with W A S D and the mouse. A bookmark is a view with handles.");
  for (const scene::ParameterGroup group : groups_of(object.kind)) {
    note_edit(draw_presets(state.scene, group, {object.index, 0}), group, state, edits);
    for (const scene::Parameter& row : scene::parameter_table()) {
      if (row.group != group || &row == name_row(object.kind)) continue;
      const bool is_of_list = row.section->is_repeated();
      const scene::ElementIndex element{is_of_list ? object.index : 0, 0};
      note_edit(parameter_widget(state.scene, row, state.edit, element), group, state, edits);
    }
  }
  ImGui::PopID();
}

/// Groups whose values are of other elements than the object's own, but belong to it.
std::vector<scene::ParameterGroup> groups_beside(ObjectKind kind) {
  using enum scene::ParameterGroup;
  switch (kind) {
    case ObjectKind::camera:
      return {bookmark, render};
    case ObjectKind::sky:
      return {render};
    case ObjectKind::sea:
      return {grid, swell, raindrop};
    case ObjectKind::wake:
      return {wake_hull};
    case ObjectKind::terrain:
      return {height_map, walk};
    case ObjectKind::cloud_layer:
      return {clouds};
    case ObjectKind::cloud:
      return {clouds, cloud_ball, cloud_level, particle_edit};
    case ObjectKind::mesh:
      return {highlight};
    case ObjectKind::body:
      return {mooring};
    case ObjectKind::bookmark:
    case ObjectKind::lake:
    case ObjectKind::light:
      return {};
  }
  return {};
}

}  // namespace

bool is_shown_with_selection(const ViewState& state, scene::ParameterGroup group) {
  const std::optional<SceneObject> selected = selected_object(state);
  if (!selected) return true;
  const std::vector<scene::ParameterGroup> groups = groups_beside(selected->kind);
  return std::ranges::find(groups, group) != groups.end();
}

void draw_outliner(ViewState& state, PanelEdits& edits) {
  if (ImGui::CollapsingHeader("Objects", ImGuiTreeNodeFlags_DefaultOpen)) {
    draw_buttons(state, edits);
    draw_list(state, edits);
  }
}

void draw_selected_values(ViewState& state, PanelEdits& edits) {
  const std::optional<SceneObject> selected = selected_object(state);
  if (!selected) return;
  draw_properties(state, *selected, edits);
  if (selected->kind != ObjectKind::mesh) return;
  if (const std::optional<std::size_t> body = body_of_mesh(state.scene, selected->index))
    draw_properties(state, {ObjectKind::body, *body}, edits);
}

}  // namespace offing::present
