#include "present/panels/panels.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/objects/selection.h"
#include "present/editing/ray_overlay.h"
#include "present/panels/bookmark_panel.h"
#include "present/panels/outliner.h"
#include "present/panels/preset_buttons.h"
#include "present/panels/scene_list_panel.h"
#include "present/panels/time_graph.h"
#include "present/panels/value_search.h"
#include "present/window/key_bindings.h"

namespace offing::present {
namespace {

using scene::ParameterGroup;

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

/// The last word of a section's name, with the number of an element; the key is in the tooltip.
void draw_section(std::string_view section, std::size_t number = 0) {
  std::string words(scene::name_of(section));
  std::ranges::replace(words, '_', ' ');
  if (number > 0) words += fmt::format(" {}", number);
  ImGui::TextDisabled("%s", words.c_str());
  if (!ImGui::IsItemHovered()) return;
  explain_item(number > 0 ? fmt::format("in scene files: [[{}]]", section)
                          : fmt::format("in scene files: [{}]", section));
}

void draw_rows(const GroupPanel& panel, const std::vector<const scene::Parameter*>& rows, ViewState& state,
               PanelEdits& edits) {
  std::string_view section;
  for (const scene::Parameter* row : rows) {
    if (scene::section_of(row->key) != section) {
      section = scene::section_of(row->key);
      // A title alone would repeat that of the panel.
      if (scene::section_of(rows.front()->key) != scene::section_of(rows.back()->key)) draw_section(section);
    }
    note(parameter_widget(state.scene, *row, state.edit), panel, state, edits);
  }
}

void draw_values(const GroupPanel& panel, const std::vector<const scene::Parameter*>& rows,
                 scene::ElementIndex element, ViewState& state, PanelEdits& edits) {
  for (const scene::Parameter* row : rows) {
    note(parameter_widget(state.scene, *row, state.edit, element), panel, state, edits);
  }
}

/// The rows of a section that may be repeated, once an element.
void draw_elements(const GroupPanel& panel, const std::vector<const scene::Parameter*>& rows,
                   ViewState& state, PanelEdits& edits) {
  const scene::Parameter& first = *rows.front();
  const std::vector<scene::ElementIndex> elements = scene::elements_of(state.scene, *first.section);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    draw_section(scene::section_of(first.key), i + 1);
    ImGui::SameLine();
    const bool is_removed = ImGui::SmallButton("remove");
    note(draw_presets(state.scene, panel.group, elements[i]), panel, state, edits);
    draw_values(panel, rows, elements[i], state, edits);
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

/// What a group's values can come from, if it is a file of its own.
void draw_file_choice(ParameterGroup group, PanelEdits& edits) {
  const auto choice = [&](const char* label, FileFilter filter) {
    if (ImGui::Button(label)) edits.wanted_file = filter;
  };
  if (group == ParameterGroup::mesh) choice("add from a file ...", FileFilter::meshes);
  if (group == ParameterGroup::cloud) choice("add from a file ...", FileFilter::clouds);
  if (group == ParameterGroup::height_map) choice("choose a map ...", FileFilter::height_maps);
  if (group == ParameterGroup::sea) choice("choose a measured spectrum ...", FileFilter::spectra);
}

void draw_group(const GroupPanel& panel, ViewState& state, PanelEdits& edits) {
  if (!ImGui::CollapsingHeader(panel.title)) return;
  if (panel.group == ParameterGroup::bookmark) return draw_bookmarks(state, edits);
  draw_file_choice(panel.group, edits);
  const std::vector<const scene::Parameter*> rows = rows_of(panel.group);
  if (rows.front()->section->is_repeated()) {
    draw_elements(panel, rows, state, edits);
  } else {
    note(draw_presets(state.scene, panel.group), panel, state, edits);
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
    case ParameterGroup::material:
    case ParameterGroup::canopy:
    case ParameterGroup::walk:
    case ParameterGroup::lake:
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

/// Of an element among values that are found: with the name of its object.
std::string title_of(const scene::Scene& scene, const GroupPanel& panel, scene::ElementIndex element,
                     std::size_t number) {
  for (const SceneObject& object : objects_of(scene)) {
    const std::vector<ParameterGroup> groups = groups_of(object.kind);
    if (object.index == element.outer && std::ranges::find(groups, panel.group) != groups.end())
      return fmt::format("{}: {}", panel.title, label_of(scene, object));
  }
  return fmt::format("{} {}", panel.title, number + 1);
}

/// Values that are found; false where there are none.
bool draw_found(ViewState& state, PanelEdits& edits, decltype(is_found)& is_in_search) {
  bool has_any = false;
  for (const GroupPanel& panel : group_panels()) {
    if (!is_in(state.scene, panel.group)) continue;
    std::vector<const scene::Parameter*> rows = rows_of(panel.group);
    std::erase_if(rows, [&](const scene::Parameter* row) {
      return !is_in_search(state.search, fmt::format("{} {}", panel.title, panel.words), *row);
    });
    if (rows.empty()) continue;
    has_any = true;
    if (!rows.front()->section->is_repeated()) {
      ImGui::TextDisabled("%s", panel.title);
      note(draw_presets(state.scene, panel.group), panel, state, edits);
      draw_values(panel, rows, {}, state, edits);
      continue;
    }
    const std::vector<scene::ElementIndex> elements = scene::elements_of(state.scene, *rows.front()->section);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      ImGui::TextDisabled("%s", title_of(state.scene, panel, elements[i], i).c_str());
      draw_values(panel, rows, elements[i], state, edits);
      ImGui::PopID();
    }
  }
  return has_any;
}

/// What the search finds: by names, else by what is said of values, else by words that begin alike.
void draw_search_results(ViewState& state, PanelEdits& edits) {
  if (draw_found(state, edits, is_found) || draw_found(state, edits, is_found_in_help)) return;
  if (!draw_found(state, edits, is_found_alike))
    ImGui::TextDisabled("no value found: try fewer or shorter words");
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

void choose_look(Look& look) {
  const auto theme = static_cast<std::size_t>(look.theme);
  if (ImGui::BeginCombo("theme", theme_names[theme])) {
    for (std::size_t i = 0; i < theme_names.size(); ++i) {
      if (ImGui::Selectable(theme_names[i], i == theme)) look.theme = static_cast<Theme>(i);
    }
    ImGui::EndCombo();
  }
  // A list, as letters that grow under the mouse would move a slider.
  const auto shown = [](float scale) { return fmt::format("{:.0f} %", 100.0f * scale); };
  if (!ImGui::BeginCombo("text size", shown(look.text_scale).c_str())) return;
  for (const float scale : text_scales) {
    if (ImGui::Selectable(shown(scale).c_str(), scale == look.text_scale)) look.text_scale = scale;
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
  ImGui::SliderFloat("hold frame rate", &state.kept_hz, 0.0f, 120.0f,
                     state.kept_hz > 0.0f ? "%.0f, coarser if slow" : "off, full quality",
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
  choose_look(state.look);
  ImGui::SliderFloat("most frames/s", &state.frame_limit_hz, 0.0f, 240.0f,
                     state.frame_limit_hz > 0.0f ? "%.0f" : "no limit", ImGuiSliderFlags_AlwaysClamp);
}

/// A button for what a key does.
void draw_action(const char* label, const char* key, ViewAction action, PanelEdits& edits,
                 bool is_possible = true) {
  ImGui::BeginDisabled(!is_possible);
  if (ImGui::Button(label)) edits.action = action;
  ImGui::EndDisabled();
  explain_item(key);
}

/// A button whose tooltip also says what it would do next.
void draw_step(const char* label, const char* key, ViewAction action, const std::string& words,
               PanelEdits& edits) {
  stay_in_line(label);
  draw_action(label, fmt::format("{}\n{}", key, words).c_str(), action, edits, !words.empty());
}

void draw_file(const ViewFacts& facts, PanelEdits& edits) {
  draw_action("new", "Ctrl N", ViewAction::new_scene, edits);
  ImGui::SameLine();
  draw_action("open ...", "Ctrl O", ViewAction::open_file, edits);
  ImGui::SameLine();
  draw_action("save", "Ctrl S", ViewAction::save, edits, facts.can_save);
  stay_in_line("save as ...");
  draw_action("save as ...", "Ctrl Shift S", ViewAction::save_as, edits);
  draw_step("undo", "Ctrl Z", ViewAction::undo, facts.undo, edits);
  draw_step("redo", "Ctrl Y", ViewAction::redo, facts.redo, edits);
}

void draw_search_field(ViewState& state, PanelEdits& edits) {
  constexpr const char* keys = "keys";
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto button_px = [&](const char* label) {
    return ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
  };
  const bool has_words = !state.search.empty();
  if (std::exchange(state.begins_search, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-button_px(keys) - (has_words ? button_px("x") : 0.0f));
  ImGui::InputTextWithHint("##search", "search values (Ctrl F)", &state.search);
  ImGui::SameLine();
  if (has_words) {
    if (ImGui::Button("x##search")) state.search.clear();
    explain_item("all values again");
    ImGui::SameLine();
  }
  draw_action(keys, "H", ViewAction::toggle_help, edits);
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

constexpr ImGuiWindowFlags side_panel =
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove;

/// Below the main panel: what is selected, or found, or else all values of the scene.
void draw_values_panel(ViewState& state, const ViewFacts& facts, PanelEdits& edits) {
  state.layout.place_values();
  ImGui::Begin("Values", nullptr, side_panel | ImGuiWindowFlags_NoTitleBar);
  const std::optional<SceneObject> selected = selected_object(state);
  if (std::exchange(state.valued, selected) != selected) ImGui::SetScrollY(0.0f);
  ImGui::PushItemWidth(item_share * ImGui::GetContentRegionAvail().x);
  ImGui::PushTextWrapPos();
  if (state.search.empty()) {
    draw_selected_values(state, edits);
  } else {
    draw_search_results(state, edits);
  }
  draw_view(state, facts);
  for (const GroupPanel& panel : group_panels()) {
    const bool is_shown = state.search.empty() && is_shown_with_selection(state, panel.group);
    if (is_shown && is_in(state.scene, panel.group)) draw_group(panel, state, edits);
  }
  if (facts.scenes != nullptr) edits.wanted_scene = draw_scene_list(*facts.scenes, facts.open_scene);
  draw_times(state, facts);
  ImGui::PopTextWrapPos();
  ImGui::PopItemWidth();
  edits.wants_original = ImGui::Button("undo all edits");
  explain_item("back to the scene as it was opened, and to its camera; Ctrl Z takes that back");
  ImGui::SameLine();
  ImGui::TextDisabled("Tab: hide panels");
  ImGui::End();
}

void draw_main_panel(ViewState& state, const ViewFacts& facts, PanelEdits& edits) {
  // What flies is what the camera's panel edits.
  state.scene.view.camera = state.camera.camera();
  state.layout.place_main(state.look.panel_em);
  const bool is_open = ImGui::Begin("Offing", nullptr, side_panel);
  draw_file(facts, edits);
  draw_search_field(state, edits);
  draw_outliner(state, edits);
  state.layout.end_main();
  ImGui::End();
  if (is_open) draw_values_panel(state, facts, edits);
  state.look.panel_em = state.layout.draw_main_edge(state.look.panel_em);
  state.camera.camera() = state.scene.view.camera;
}

void draw_help(PanelLayout& layout, bool& is_open) {
  layout.place_right();
  ImGui::Begin(
      "Keys", &is_open,
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing);
  constexpr float usual_em = 44.0f;
  const float room =
      layout.right_width() - 2.0f * ImGui::GetStyle().WindowPadding.x - ImGui::GetStyle().ScrollbarSize;
  const float width = std::min(usual_em * ImGui::GetFontSize(), room);
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_None, ImVec2(width, 0.0f))) {
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("does", ImGuiTableColumnFlags_WidthStretch);
    const auto row = [](const char* name, const char* help) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(name);
      ImGui::TableNextColumn();
      ImGui::TextWrapped("%s", help);
    };
    for (const CameraControl& control : camera_controls()) row(control.name, control.help);
    for (const KeyBinding& binding : key_bindings()) row(binding.name, binding.help);
    row("Click", "on a slider: type its value");
    ImGui::EndTable();
  }
  layout.end_right();
  ImGui::End();
}

void draw_terrain_layers(ViewState& state, const ViewFacts& facts, PanelEdits& edits) {
  if (state.pick) draw_ray_overlay(*state.pick, *facts.terrain, state.camera.camera());
  if (state.terrain == TerrainShow::steps) draw_step_legend(state.layout);
  if (state.shows_map && facts.map) edits.wanted_place = facts.map->draw(state.camera.camera(), state.layout);
}

void draw_message(Message& message, const PanelLayout& layout) {
  layout.place_message();
  ImGui::SetNextWindowBgAlpha(1.0f);  // where room is narrow it lies over a panel
  ImGui::Begin("Message", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushTextWrapPos(layout.message_width() - ImGui::GetStyle().WindowPadding.x);
  ImGui::SmallButton("x");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, message.is_fault ? fault_colour() : ImGui::GetColorU32(ImGuiCol_Text));
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  const bool is_dismissed = ImGui::IsWindowHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  ImGui::End();
  if (is_dismissed) message = {};
}

}  // namespace

std::span<const GroupPanel> group_panels() {
  static constexpr auto panels = std::to_array<GroupPanel>(
      {{ParameterGroup::wind, "Wind"},
       {ParameterGroup::sea, "Spectrum", "waves sea state swell storm"},
       {ParameterGroup::grid, "Cascades and Gerstner waves"},
       {ParameterGroup::swell, "Swells"},
       {ParameterGroup::raindrop, "Raindrops"},
       {ParameterGroup::wake, "Wakes"},
       {ParameterGroup::wake_hull, "Hulls of wakes"},
       {ParameterGroup::foam, "Foam"},
       {ParameterGroup::terrain, "Ground", "terrain land map mountains"},
       {ParameterGroup::height_map, "Height map", "terrain geotiff elevation"},
       {ParameterGroup::material, "Materials", "terrain ground rock sand grass soil colour"},
       {ParameterGroup::canopy, "Woods", "terrain forest trees canopy"},
       {ParameterGroup::walk, "Walk"},
       {ParameterGroup::lake, "Lakes", "water tarn pond reservoir"},
       {ParameterGroup::mesh, "Meshes", "object model shape ship boat"},
       {ParameterGroup::highlight, "Highlights"},
       {ParameterGroup::light, "Lights", "lantern shine"},
       {ParameterGroup::body, "Floating bodies", "boat ship hull engine drive sail"},
       {ParameterGroup::mooring, "Mooring lines"},
       {ParameterGroup::clouds, "All clouds"},
       {ParameterGroup::cloud_layer, "Layers of clouds", "sky weather overcast"},
       {ParameterGroup::cloud, "Clouds", "sky weather"},
       {ParameterGroup::cloud_ball, "Balls of clouds"},
       {ParameterGroup::cloud_level, "Levels of clouds"},
       {ParameterGroup::particle_edit, "Edits of particles"},
       {ParameterGroup::sun, "Sun", "time of day hour morning noon evening light"},
       {ParameterGroup::sky, "Air"},
       {ParameterGroup::camera, "Camera", "view position"},
       {ParameterGroup::bookmark, "Bookmarks"},
       {ParameterGroup::render, "Picture", "brightness exposure"},
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
  state.layout.begin();
  if (state.shows_panels) draw_main_panel(state, facts, edits);
  if (state.shows_panels) {
    const TimelineEdits timeline =
        draw_timeline(state.scene, state.clock, state.timeline, facts.recording, state.layout);
    edits.scene = std::max(edits.scene, timeline.scene);
    if (timeline.wants_recording) edits.action = ViewAction::record;
    edits.cancels_recording = timeline.cancels_recording;
  }
  if (state.shows_help) draw_help(state.layout, state.shows_help);
  if (facts.terrain) draw_terrain_layers(state, facts, edits);
  if (!state.message.text.empty()) draw_message(state.message, state.layout);
  return edits;
}

}  // namespace offing::present
