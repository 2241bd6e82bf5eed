#include "present/panels/panels.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/presets.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/ray_overlay.h"
#include "present/panels/bookmark_panel.h"
#include "present/panels/outliner.h"
#include "present/panels/scene_list_panel.h"
#include "present/panels/time_graph.h"
#include "present/window/key_bindings.h"

namespace offing::present {
namespace {

using scene::ParameterGroup;

constexpr float margin = 8.0f;  // between panels and the window's edge, px
constexpr ImU32 fault_colour = IM_COL32(255, 115, 90, 255);

/// The group's rows by section, otherwise in the table's order.
std::vector<const scene::Parameter*> rows_of(ParameterGroup group) {
  std::vector<const scene::Parameter*> rows;
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (row.group == group) rows.push_back(&row);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) {
    return scene::section_of(a->key) < scene::section_of(b->key);
  });
  return rows;
}

/// Of two edits of a frame the one that asks for more.
void note(Edit edit, const GroupPanel& panel, ViewState& state, PanelEdits& edits) {
  if (edit == Edit::refused) state.message = {.text = state.edit.fault, .is_fault = true};
  if (panel.group == ParameterGroup::camera) {
    edits.is_camera_moved = edits.is_camera_moved || edit != Edit::none;
  } else {
    edits.scene = std::max(edits.scene, edit);
  }
}

void draw_rows(const GroupPanel& panel, const std::vector<const scene::Parameter*>& rows, ViewState& state,
               PanelEdits& edits) {
  std::string_view section;
  for (const scene::Parameter* row : rows) {
    if (scene::section_of(row->key) != section) {
      section = scene::section_of(row->key);
      ImGui::TextDisabled(row->max_count > 1 ? "[[%s]]" : "[%s]", std::string(section).c_str());
    }
    note(parameter_widget(state.scene, *row, state.edit), panel, state, edits);
  }
}

/// The rows of a section that may be repeated, once an element.
void draw_elements(const GroupPanel& panel, const std::vector<const scene::Parameter*>& rows,
                   ViewState& state, PanelEdits& edits) {
  const scene::Parameter& first = *rows.front();
  const std::vector<scene::ElementIndex> elements = scene::elements_of(state.scene, *first.section);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::TextDisabled("[[%s]] %zu", std::string(scene::section_of(first.key)).c_str(), i + 1);
    ImGui::SameLine();
    const bool is_removed = ImGui::SmallButton("remove");
    for (const scene::Parameter* row : rows) {
      note(parameter_widget(state.scene, *row, state.edit, elements[i]), panel, state, edits);
    }
    ImGui::PopID();
    if (!is_removed) continue;
    scene::remove_element(state.scene, *first.section, elements[i]);
    note(Edit::done, panel, state, edits);
    break;
  }
  ImGui::BeginDisabled(elements.size() >= first.max_count);
  if (ImGui::Button(fmt::format("add##{}", panel.title).c_str())) {
    scene::append_element(state.scene, first, {.subject = std::string(first.key)});
    note(Edit::done, panel, state, edits);
  }
  ImGui::EndDisabled();
}

/// The presets of a group, to choose from.
void draw_presets(const GroupPanel& panel, ViewState& state, PanelEdits& edits) {
  const auto is_of_group = [&](const scene::Preset& preset) { return preset.group == panel.group; };
  if (std::ranges::none_of(scene::presets(), is_of_group)) return;
  if (!ImGui::BeginCombo("preset", "choose")) return;
  for (const scene::Preset& preset : scene::presets()) {
    if (!is_of_group(preset) || !ImGui::Selectable(std::string(preset.label).c_str())) continue;
    scene::apply(preset, state.scene);
    note(Edit::done, panel, state, edits);
  }
  ImGui::EndCombo();
}

void draw_group(const GroupPanel& panel, ViewState& state, PanelEdits& edits) {
  if (!ImGui::CollapsingHeader(panel.title)) return;
  if (panel.group == ParameterGroup::bookmark) return draw_bookmarks(state, edits);
  draw_presets(panel, state, edits);
  const std::vector<const scene::Parameter*> rows = rows_of(panel.group);
  if (rows.front()->section->is_repeated()) {
    draw_elements(panel, rows, state, edits);
  } else {
    draw_rows(panel, rows, state, edits);
  }
  if (panel.group == ParameterGroup::camera) {
    ImGui::TextDisabled("flies at %.3g m/s", state.camera.speed_mps());
  }
}

/// Whether a scene has what a group says something about.
bool is_in(const scene::Scene& scene, ParameterGroup group) {
  switch (group) {
    case ParameterGroup::wind:
    case ParameterGroup::sea:
    case ParameterGroup::grid:
    case ParameterGroup::swell:
    case ParameterGroup::raindrop:
    case ParameterGroup::wake:
    case ParameterGroup::wake_hull:
    case ParameterGroup::foam:
      return scene.has_sea();
    case ParameterGroup::body:
    case ParameterGroup::mooring:
      return scene.has_sea() && !scene.meshes.empty();
    case ParameterGroup::terrain:
    case ParameterGroup::height_map:
    case ParameterGroup::walk:
      return scene.terrain.is_given;
    case ParameterGroup::mesh:
    case ParameterGroup::highlight:
    case ParameterGroup::light:
      return !scene.meshes.empty();
    case ParameterGroup::clouds:
    case ParameterGroup::cloud_layer:
    case ParameterGroup::cloud:
    case ParameterGroup::cloud_ball:
    case ParameterGroup::cloud_level:
    case ParameterGroup::particle_edit:
      return scene.has_clouds();
    default:
      return true;
  }
}

void draw_clock(ViewState& state) {
  const double frame_s = 1.0 / state.scene.time.frames_per_second;
  if (ImGui::Button(state.clock.is_paused() ? "run##clock" : "pause##clock")) state.clock.toggle_pause();
  ImGui::SameLine();
  if (ImGui::ArrowButton("step back", ImGuiDir_Left)) state.clock.step(-frame_s);
  ImGui::SameLine();
  if (ImGui::ArrowButton("step forward", ImGuiDir_Right)) state.clock.step(frame_s);
  ImGui::SameLine();
  ImGui::Text("%.3f s", state.clock.time_s());
  float scale = static_cast<float>(state.clock.scale());
  if (ImGui::SliderFloat("time scale", &scale, 1.0f / 64.0f, 64.0f, "%.3g", ImGuiSliderFlags_Logarithmic)) {
    state.clock.set_scale(scale);
  }
}

void draw_terrain_view(ViewState& state) {
  bool shows_steps = state.terrain == TerrainShow::steps;
  if (ImGui::Checkbox("steps of rays", &shows_steps)) {
    state.terrain = shows_steps ? TerrainShow::steps : TerrainShow::light;
  }
  ImGui::SameLine();
  ImGui::Checkbox("map", &state.shows_map);
  constexpr std::array<const char*, ray_shares.size()> names{"each pixel", "3/4 of the pixels",
                                                             "1/2 of the pixels", "1/4 of the pixels"};
  if (ImGui::BeginCombo("rays", names[static_cast<std::size_t>(state.rays)])) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto choice = static_cast<RayChoice>(i);
      if (ImGui::Selectable(names[i], choice == state.rays)) state.rays = choice;
    }
    ImGui::EndCombo();
  }
}

/// A list of what can be shown, of which one is.
template <class Show, std::size_t count>
void choose(const char* label, const std::array<Show, count>& all, Show& shown) {
  if (!ImGui::BeginCombo(label, std::string(to_string(shown)).c_str())) return;
  for (const Show show : all) {
    if (ImGui::Selectable(std::string(to_string(show)).c_str(), show == shown)) shown = show;
  }
  ImGui::EndCombo();
}

void draw_view(ViewState& state, const ViewFacts& facts) {
  if (!ImGui::CollapsingHeader("View")) return;
  if (facts.terrain) draw_terrain_view(state);
  choose("show", all_water_shows, state.debug);
  if (facts.has_meshes) choose("meshes show", all_mesh_shows, state.meshes);
  bool is_wireframe = state.fill == Fill::wireframe;
  if (ImGui::Checkbox("wireframe", &is_wireframe)) state.fill = is_wireframe ? Fill::wireframe : Fill::solid;
  ImGui::SliderFloat("keep frames/s", &state.kept_hz, 0.0f, 120.0f,
                     state.kept_hz > 0.0f ? "%.0f by quality" : "no, keep quality",
                     ImGuiSliderFlags_AlwaysClamp);
  if (state.kept_hz > 0.0f) {
    const Quality& now = facts.quality;
    ImGui::TextDisabled("now sides %.0f %%, rays %.0f %%, grid %.0f %%, mirror images %.0f %%,",
                        100.0 * now.side_share, 100.0 * now.ray_share, 100.0 * now.grid_share,
                        100.0 * now.views_share);
    ImGui::TextDisabled("sea samples %.0f %%, particles of clouds %.0f %%", 100.0 / (1 << now.sea_halvings),
                        100.0 / (1 << now.cloud_halvings));
  }
  ImGui::SliderFloat("render scale", &state.render_scale, 0.1f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SliderFloat("most frames/s", &state.frame_limit_hz, 0.0f, 240.0f,
                     state.frame_limit_hz > 0.0f ? "%.0f" : "no limit", ImGuiSliderFlags_AlwaysClamp);
}

void draw_file(ViewState& state, PanelEdits& edits) {
  if (!ImGui::CollapsingHeader("Scene file")) return;
  ImGui::InputText("name", &state.save_name);
  edits.wants_save = ImGui::Button("save scene as");
  ImGui::SameLine();
  bool is_overwriting = state.existing == Existing::replace;
  ImGui::Checkbox("overwrite", &is_overwriting);
  state.existing = is_overwriting ? Existing::replace : Existing::keep;
  edits.wants_original = ImGui::Button("undo all edits");
}

void draw_times(ViewState& state, const ViewFacts& facts) {
  if (!ImGui::CollapsingHeader("Frame times")) return;
  ImGui::Text("%.1f frames/s, %d x %d", facts.times.frames_per_second(), facts.width_px, facts.height_px);
  const auto choice = [&](const char* label, TimeSource source) {
    if (ImGui::RadioButton(label, state.shown_times == source)) state.shown_times = source;
  };
  choice("CPU's clock", TimeSource::cpu);
  ImGui::SameLine();
  choice("device's clock", TimeSource::device);
  draw_time_graph(facts.times, state.shown_times);
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("OpenGL %d.%d: %s", facts.capabilities.major, facts.capabilities.minor,
                      facts.capabilities.renderer.c_str());
  ImGui::TextDisabled("OpenCL: %s", facts.device.name.c_str());
  ImGui::TextDisabled("transfer: %s", std::string(to_string(facts.transfer)).c_str());
  ImGui::PopTextWrapPos();
}

void draw_main_panel(ViewState& state, const ViewFacts& facts, PanelEdits& edits) {
  // What flies is what the camera's panel edits.
  state.scene.view.camera = state.camera.camera();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = 27.0f * ImGui::GetFontSize();
  ImGui::SetNextWindowPos(ImVec2(margin, margin), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));  // as high as what is open, up to the window's height
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 40.0f),
                                      ImVec2(width, std::max(80.0f, screen.y - 2.0f * margin)));
  ImGui::Begin("Offing", nullptr, ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoResize);
  ImGui::PushItemWidth(11.0f * ImGui::GetFontSize());
  draw_clock(state);
  draw_outliner(state, edits);
  draw_view(state, facts);
  for (const GroupPanel& panel : group_panels()) {
    if (is_in(state.scene, panel.group) && is_shown_with_selection(state, panel.group))
      draw_group(panel, state, edits);
  }
  if (facts.scenes != nullptr) edits.wanted_scene = draw_scene_list(*facts.scenes, facts.open_scene);
  draw_file(state, edits);
  draw_times(state, facts);
  ImGui::PopItemWidth();
  ImGui::TextDisabled("H: keys; Tab: without panels");
  ImGui::End();
  state.camera.camera() = state.scene.view.camera;
}

void draw_help() {
  ImGui::SetNextWindowPos(ImVec2(ImGui::GetIO().DisplaySize.x - margin, margin), ImGuiCond_FirstUseEver,
                          ImVec2(1.0f, 0.0f));
  ImGui::Begin(
      "Keys", nullptr,
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing);
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    const auto row = [](const char* name, const char* help) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(name);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(help);
    };
    for (const CameraControl& control : camera_controls()) row(control.name, control.help);
    for (const KeyBinding& binding : key_bindings()) row(binding.name, binding.help);
    row("Ctrl click", "on a slider: type its value");
    ImGui::EndTable();
  }
  ImGui::End();
}

void draw_terrain_layers(const ViewState& state, const ViewFacts& facts, PanelEdits& edits) {
  if (state.pick) draw_ray_overlay(*state.pick, *facts.terrain, state.camera.camera());
  if (state.terrain == TerrainShow::steps) draw_step_legend();
  if (state.shows_map && facts.map) edits.wanted_place = facts.map->draw(state.camera.camera());
}

void draw_message(Message& message) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0.0f, screen.y), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(screen.x, 0.5f * screen.y));
  ImGui::Begin("Message", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  const bool is_dismissed = ImGui::SmallButton("dismiss");
  ImGui::PushTextWrapPos(screen.x - 2.0f * ImGui::GetFontSize());
  ImGui::PushStyleColor(ImGuiCol_Text, message.is_fault ? fault_colour : ImGui::GetColorU32(ImGuiCol_Text));
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::End();
  if (is_dismissed) message = {};
}

}  // namespace

std::span<const GroupPanel> group_panels() {
  static constexpr auto panels =
      std::to_array<GroupPanel>({{ParameterGroup::wind, "Wind"},
                                 {ParameterGroup::sea, "Spectrum"},
                                 {ParameterGroup::grid, "Cascades and Gerstner waves"},
                                 {ParameterGroup::swell, "Swells"},
                                 {ParameterGroup::raindrop, "Raindrops"},
                                 {ParameterGroup::wake, "Wakes"},
                                 {ParameterGroup::wake_hull, "Hulls of wakes"},
                                 {ParameterGroup::foam, "Foam"},
                                 {ParameterGroup::terrain, "Ground"},
                                 {ParameterGroup::height_map, "Height map"},
                                 {ParameterGroup::walk, "Walk"},
                                 {ParameterGroup::mesh, "Meshes"},
                                 {ParameterGroup::highlight, "Highlights"},
                                 {ParameterGroup::light, "Lights"},
                                 {ParameterGroup::body, "Floating bodies"},
                                 {ParameterGroup::mooring, "Mooring lines"},
                                 {ParameterGroup::clouds, "All clouds"},
                                 {ParameterGroup::cloud_layer, "Layers of clouds"},
                                 {ParameterGroup::cloud, "Clouds"},
                                 {ParameterGroup::cloud_ball, "Balls of clouds"},
                                 {ParameterGroup::cloud_level, "Levels of clouds"},
                                 {ParameterGroup::particle_edit, "Edits of particles"},
                                 {ParameterGroup::sun, "Sun"},
                                 {ParameterGroup::sky, "Air"},
                                 {ParameterGroup::camera, "Camera"},
                                 {ParameterGroup::bookmark, "Bookmarks"},
                                 {ParameterGroup::render, "Picture"},
                                 {ParameterGroup::world, "World"},
                                 {ParameterGroup::time, "Time of the scene"}});
  return panels;
}

Message fault_message(const Error& error) {
  return {.text = fmt::format("{}{}{}", error.what(), error.hint().empty() ? "" : "\n", error.hint()),
          .is_fault = true};
}

PanelEdits draw_panels(ViewState& state, const ViewFacts& facts) {
  PanelEdits edits;
  if (state.shows_panels) draw_main_panel(state, facts, edits);
  if (state.shows_help) draw_help();
  if (facts.terrain) draw_terrain_layers(state, facts, edits);
  if (!state.message.text.empty()) draw_message(state.message);
  return edits;
}

}  // namespace offing::present
