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
#include "present/editing/cloud_edits.h"
#include "present/editing/objects/selection.h"
#include "present/panels/panel_layout.h"
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
                         body_of_part(scene, object).has_value();
  return is_nested ? 1.0f : 0.0f;
}

/// What a row hides and shows: a mesh, or all those of a body.
std::vector<std::size_t> meshes_of_row(const scene::Scene& scene, const SceneObject& object) {
  if (object.kind == ObjectKind::mesh) return {object.index};
  std::vector<std::size_t> meshes;
  if (object.kind != ObjectKind::body) return meshes;
  for (const SceneObject& part : parts_of_body(scene, object.index)) {
    if (part.kind == ObjectKind::mesh) meshes.push_back(part.index);
  }
  return meshes;
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
  explain_item("X");
  ImGui::EndDisabled();
}

/// In the place of a row: Enter takes the name, Esc and a click elsewhere leave the one before.
void draw_name_field(ViewState& state, PanelEdits& edits) {
  Renaming& renaming = *state.renaming;
  ImGui::SetNextItemWidth(-1.0f);
  if (renaming.is_new) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(ImGui::GetStyle().FramePadding.x, 0.0f));  // as high as a row
  const bool is_entered = ImGui::InputText(
      "##new name", &renaming.text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
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

/// A name that is too long for its row ends in dots.
std::string shortened(std::string name, float width_px) {
  if (ImGui::CalcTextSize(name.c_str()).x <= width_px) return name;
  const auto is_within_letter = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; };
  while (!name.empty() && ImGui::CalcTextSize((name + "...").c_str()).x > width_px) {
    while (!name.empty() && is_within_letter(name.back())) name.pop_back();
    if (!name.empty()) name.pop_back();
  }
  return name + "...";
}

constexpr float eye_ems = 1.6f;

bool has_eye(const scene::Scene& scene, const SceneObject& object) {
  return object.kind == ObjectKind::cloud || object.kind == ObjectKind::cloud_layer ||
         !meshes_of_row(scene, object).empty();
}

bool is_row_shown(const scene::Scene& scene, const SceneObject& object) {
  if (object.kind == ObjectKind::cloud) return !is_hidden(scene, object.index);
  if (object.kind == ObjectKind::cloud_layer)
    return scene.cloud_layers[object.index].visible == scene::CloudVisibility::on;
  const std::size_t mesh = meshes_of_row(scene, object).front();
  return scene.meshes[mesh].material.visible == world::MeshVisibility::on;
}

/// Hides what is shown, and shows what is hidden.
void turn_visibility(scene::Scene& scene, const SceneObject& object) {
  const bool is_shown = is_row_shown(scene, object);
  const auto of_cloud = is_shown ? scene::CloudVisibility::off : scene::CloudVisibility::on;
  if (object.kind == ObjectKind::cloud) scene.clouds[object.index].visible = of_cloud;
  if (object.kind == ObjectKind::cloud_layer) scene.cloud_layers[object.index].visible = of_cloud;
  for (const std::size_t mesh : meshes_of_row(scene, object)) {
    scene.meshes[mesh].material.visible = is_shown ? world::MeshVisibility::off : world::MeshVisibility::on;
  }
}

/// At the end of a row: an eye that is open, or struck through where the object is hidden.
void draw_eye(ViewState& state, const SceneObject& object, PanelEdits& edits) {
  const float em = ImGui::GetFontSize();
  const bool is_shown = is_row_shown(state.scene, object);
  ImGui::SameLine(0.0f, 0.0f);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##visible", {eye_ems * em, ImGui::GetTextLineHeight()})) {
    turn_visibility(state.scene, object);
    edits.scene = Edit::done;
  }
  explain_item(is_shown ? "hide" : "hidden: click to show");
  const ImVec2 middle(corner.x + 0.5f * eye_ems * em, corner.y + 0.5f * ImGui::GetTextLineHeight());
  const ImU32 colour = ImGui::GetColorU32(is_shown ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // Two arcs of 90 degrees that meet in the corners.
  constexpr float quarter = 1.5707963f;
  const float radius = 0.71f * em, rise = 0.5f * em;
  list.PathArcTo({middle.x, middle.y + rise}, radius, -1.5f * quarter, -0.5f * quarter, 8);
  list.PathArcTo({middle.x, middle.y - rise}, radius, 0.5f * quarter, 1.5f * quarter, 8);
  list.PathStroke(colour, ImDrawFlags_Closed, 1.2f);
  list.AddCircleFilled(middle, 0.15f * em, colour);
  if (is_shown) return;
  const float across = 0.45f * em, high = 0.36f * em;
  list.AddLine({middle.x - across, middle.y + high}, {middle.x + across, middle.y - high},
               ImGui::GetColorU32(ImGuiCol_Text), 1.5f);
}

/// How a row is shown.
enum class RowShow { plain, selected, newly_selected };

/// Before the row of a body: an arrow that opens and closes its parts. True while they are open.
bool draw_arrow(float width_px, bool has_to_be_open) {
  const float em = ImGui::GetFontSize(), height = ImGui::GetTextLineHeight();
  bool& is_open = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("is open"), false);
  is_open = is_open || has_to_be_open;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##open", {width_px, height})) is_open = !is_open;
  explain_item(is_open ? "close" : "show hull, meshes aboard and wakes");
  ImGui::SameLine(0.0f, 0.0f);
  const ImVec2 middle(corner.x + 0.6f * em, corner.y + 0.5f * height);
  const float side = 0.28f * em;
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (is_open) {
    list.AddTriangleFilled({middle.x - side, middle.y - 0.6f * side},
                           {middle.x + side, middle.y - 0.6f * side}, {middle.x, middle.y + side}, colour);
  } else {
    list.AddTriangleFilled({middle.x - 0.6f * side, middle.y - side},
                           {middle.x - 0.6f * side, middle.y + side}, {middle.x + side, middle.y}, colour);
  }
  return is_open;
}

/// True if its parts are to follow. `has_to_be_open`: one of them has just been selected.
bool draw_row(ViewState& state, const SceneObject& object, RowShow show, bool has_to_be_open,
              PanelEdits& edits) {
  const bool is_selected = show != RowShow::plain, is_body = object.kind == ObjectKind::body;
  const float em = ImGui::GetFontSize(), indent = (1.2f + depth_of(state.scene, object)) * em;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool is_open = is_body && draw_arrow(indent, has_to_be_open);
  if (state.renaming && state.renaming->object == object) {
    draw_name_field(state, edits);
    return is_open;
  }
  const bool with_eye = has_eye(state.scene, object);
  const ImVec2 size(ImGui::GetContentRegionAvail().x - (with_eye ? eye_ems * em : 0.0f), 0.0f);
  if (ImGui::Selectable("##object", is_selected, ImGuiSelectableFlags_AllowDoubleClick, size)) {
    if (!is_selected) select_object(state, object);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) open_row(state, object, edits);
  }
  const float name_px = corner.x + indent + 1.1f * em, name_end_px = ImGui::GetItemRectMax().x;
  const float top = ImGui::GetWindowPos().y, end = top + ImGui::GetWindowHeight();
  const bool is_whole = ImGui::GetItemRectMin().y >= top && ImGui::GetItemRectMax().y <= end;
  if (show == RowShow::newly_selected && !is_whole) ImGui::SetScrollHereY();
  // Names can hold what ImGui takes for the end of a label: they are text beside a row without one.
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = corner.y + 0.5f * ImGui::GetTextLineHeight();
  list.AddCircleFilled({corner.x + indent + 0.4f * em, middle}, 0.28f * em, colour_of(object.kind));
  list.AddText({name_px, corner.y}, ImGui::GetColorU32(ImGuiCol_Text),
               shortened(label_of(state.scene, object), name_end_px - name_px).c_str());
  if (with_eye) draw_eye(state, object, edits);
  return is_open;
}

void draw_list(ViewState& state, PanelEdits& edits) {
  // There is to be room for the values below the list.
  constexpr float least_rows = 4.0f, most_rows = 12.0f, most_share = 0.4f;
  const float room = most_share * state.layout.main_room() / ImGui::GetTextLineHeightWithSpacing() - 1.0f;
  const std::vector<SceneObject> objects = objects_of(state.scene);
  const std::optional<SceneObject> selected = selected_object(state);
  const bool is_new = selected != state.listed;
  const std::optional<std::size_t> opened =
      is_new && selected ? body_of_part(state.scene, *selected) : std::nullopt;
  const float rows =
      std::min(static_cast<float>(objects.size()), std::clamp(std::floor(room), least_rows, most_rows));
  const float height_px =
      rows * ImGui::GetTextLineHeightWithSpacing() + 2.0f * ImGui::GetStyle().WindowPadding.y;
  ImGui::BeginChild("objects", ImVec2(0.0f, height_px), true);
  bool are_parts_open = false;
  for (const SceneObject& object : objects) {
    const bool is_body = object.kind == ObjectKind::body;
    if (!is_body && !are_parts_open && body_of_part(state.scene, object)) continue;
    // Where a list changes while one of its rows is open, the row is gone.
    ImGui::PushID(static_cast<int>(object.kind));
    ImGui::PushID(static_cast<int>(object.index));
    const RowShow show = is_new ? RowShow::newly_selected : RowShow::selected;
    const bool is_open = draw_row(state, object, object == selected ? show : RowShow::plain,
                                  is_body && opened == object.index, edits);
    if (is_body) are_parts_open = is_open;
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

void draw_object_values(ViewState& state, const SceneObject& object, PanelEdits& edits) {
  if (object.kind == ObjectKind::bookmark) draw_view_buttons(state, object.index, edits);
  if (object.kind == ObjectKind::camera)
    ImGui::TextDisabled("Fly with W A S D and the mouse. A bookmark is a view with handles.");
  std::vector<scene::ParameterGroup> groups = groups_of(object.kind);
  // First where the ground comes from.
  if (object.kind == ObjectKind::terrain && state.scene.terrain.file.empty()) std::ranges::reverse(groups);
  for (const scene::ParameterGroup group : groups) {
    const auto panel = std::ranges::find(group_panels(), group, &GroupPanel::group);
    if (groups.size() > 1) ImGui::TextDisabled("%s", panel->title);
    note_edit(draw_presets(state.scene, group, {object.index, 0}), group, state, edits);
    for (const scene::Parameter& row : scene::parameter_table()) {
      if (row.group != group || &row == name_row(object.kind)) continue;
      const bool is_of_list = row.section->is_repeated();
      const scene::ElementIndex element{is_of_list ? object.index : 0, 0};
      note_edit(parameter_widget(state.scene, row, state.edit, element), group, state, edits);
    }
  }
  if (object.kind != ObjectKind::body) return;
  if (ImGui::Button("stop floating"))
    edits.object = ObjectEdit{.kind = ObjectEdit::Kind::stop_floating, .object = object};
  explain_item("removes the body and its wakes; its meshes stay where it starts");
}

/// Below the selected object.
void draw_part_values(ViewState& state, const SceneObject& part, PanelEdits& edits) {
  const int kind = static_cast<int>(part.kind), index = static_cast<int>(part.index);
  ImGui::PushID(kind);
  ImGui::PushID(index);
  const bool is_body = part.kind == ObjectKind::body;
  const std::string title =
      fmt::format("{}{}###values", is_body ? "body and engine: " : "", label_of(state.scene, part));
  if (ImGui::CollapsingHeader(title.c_str())) draw_object_values(state, part, edits);
  ImGui::PopID();
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
      return {material, canopy, walk};
    case ObjectKind::cloud_layer:
      return {clouds};
    case ObjectKind::cloud:
      return {clouds, cloud_ball, cloud_level, particle_edit};
    case ObjectKind::mesh:
      return {highlight};
    case ObjectKind::body:
      return {mooring, wake_hull, highlight};
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
  const std::string title = fmt::format("{}###selected", label_of(state.scene, *selected));
  if (ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) {
    ImGui::PushID("properties");
    draw_object_values(state, *selected, edits);
    ImGui::PopID();
  }
  // All that makes up a boat, whichever part of it is selected.
  const std::optional<std::size_t> body = selected->kind == ObjectKind::body
                                              ? std::optional(selected->index)
                                              : body_of_part(state.scene, *selected);
  if (!body) return;
  std::vector<SceneObject> parts = parts_of_body(state.scene, *body);
  parts.insert(parts.begin(), {ObjectKind::body, *body});
  for (const SceneObject& part : parts) {
    if (part != *selected) draw_part_values(state, part, edits);
  }
}

}  // namespace offing::present
