#include "present/panels/cloud_panel.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "host/clouds/shape/genera.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/schema/parameter_table.h"
#include "present/editing/cloud_editor.h"
#include "present/editing/objects/selection.h"
#include "present/panels/sun_dial.h"

namespace offing::present {
namespace {

std::string name_of(clouds::Genus genus) {
  return std::string(clouds::range_of(genus).name);
}

/// Whether another one was chosen.
bool choose_genus(const char* label, clouds::Genus& genus) {
  bool is_chosen = false;
  if (!ImGui::BeginCombo(label, name_of(genus).c_str())) return false;
  for (const clouds::Genus other : clouds::all_genera) {
    if (!ImGui::Selectable(name_of(other).c_str(), other == genus)) continue;
    genus = other;
    is_chosen = true;
  }
  ImGui::EndCombo();
  return is_chosen;
}

void draw_tools(CloudEditing& editing) {
  ImGui::TextUnformatted("clicks pick");
  for (std::size_t i = 0; i < cloud_pick_names.size(); ++i) {
    if (i % 2 > 0) ImGui::SameLine(0.5f * side_text_em * ImGui::GetFontSize());
    const auto pick = static_cast<CloudPick>(i);
    if (!ImGui::RadioButton(cloud_pick_names[i], editing.pick == pick && editing.tool == CloudTool::pick))
      continue;
    if (editing.pick != pick) editing.forget_picks();
    editing.pick = pick;
    editing.tool = CloudTool::pick;
  }
  if (ImGui::RadioButton("place balls", editing.tool == CloudTool::place_ball))
    editing.tool = CloudTool::place_ball;
  ImGui::SameLine(0.5f * side_text_em * ImGui::GetFontSize());
  if (ImGui::RadioButton("place clouds", editing.tool == CloudTool::place_cloud))
    editing.tool = CloudTool::place_cloud;
  if (editing.tool != CloudTool::pick) choose_genus("genus of new clouds", editing.genus);
  const auto metres = [](const char* label, double& value, double low, double high) {
    ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &low, &high, "%.6g m",
                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  };
  if (editing.tool == CloudTool::place_ball) metres("radius of new balls", editing.new_radius_m, 1.0, 1e4);
  metres("step with Ctrl", editing.step_m, 1.0, 1e3);
}

/// A widget for each value of a ball; what they change is written into a copy of the clouds first, which has
/// the balls that a genus gives.
Edit draw_ball(ViewState& state, std::size_t cloud, std::size_t ball) {
  scene::Scene copy;
  scene::copy_clouds(state.scene, copy);
  own_balls(copy, cloud);
  Edit edit = Edit::none;
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (row.group == scene::ParameterGroup::cloud_ball)
      edit = std::max(edit, parameter_widget(copy, row, state.edit, {cloud, ball}));
  }
  if (edit == Edit::refused) state.message = {.text = state.edit.fault, .is_fault = true};
  if (edit != Edit::none) scene::copy_clouds(copy, state.scene);
  return edit;
}

Edit draw_picked_part(ViewState& state) {
  const CloudPart part = state.clouds.picked.back();
  const std::string& name = state.scene.clouds[part.cloud].name;
  ImGui::Separator();
  ImGui::Text("%zu picked; cloud %zu%s%s%s", state.clouds.picked.size(), part.cloud + 1,
              name.empty() ? "" : ", ", name.c_str(),
              part.ball ? fmt::format(", ball {}", *part.ball + 1).c_str() : "");
  // Those of the cloud itself are below the list of objects.
  Edit edit = part.ball ? draw_ball(state, part.cloud, *part.ball) : Edit::none;
  // Not before: what values change is another list of clouds.
  scene::CloudScene& cloud = state.scene.clouds[part.cloud];
  clouds::Genus genus = cloud.genus;
  if (choose_genus("genus", genus)) {
    apply_genus(state.scene, part.cloud, genus);
    edit = Edit::done;
  }
  ImGui::BeginDisabled(cloud.balls.empty());
  if (ImGui::Button("balls of the genus")) {
    cloud.balls.clear();
    cloud.base_m.reset();
    edit = Edit::done;
  }
  ImGui::EndDisabled();
  return edit;
}

Edit draw_picked_particles(ViewState& state) {
  PickedParticles& picked = state.clouds.particles;
  ImGui::Separator();
  ImGui::Text("picked particles: %zu", picked.places_m.size());
  const PickedParticles::InCloud& first = picked.clouds.front();
  const std::vector<clouds::ParticleEdit>& edits = state.scene.clouds[first.cloud].edits;
  glm::vec3 colour(1.0f);
  if (first.edit && edits[*first.edit].albedo) colour = glm::vec3(*edits[*first.edit].albedo);
  Edit edit = Edit::none;
  if (ImGui::ColorEdit3("colour", &colour.x, ImGuiColorEditFlags_Float)) {
    colour_particles(state.scene, picked, glm::dvec3(colour));
    edit = Edit::going_on;
  }
  if (ImGui::IsItemDeactivatedAfterEdit()) edit = Edit::done;
  return edit;
}

Edit draw_sun(ViewState& state) {
  ImGui::Separator();
  sky::SunAngles now = state.scene.view.sun_direction;
  try {
    now = scene::view_at(state.scene, state.clock.time_s()).sun_direction;
  } catch (const Error&) {
    // A time beyond the sun's calendar, which the picture tells of.
  }
  return draw_sun_dial(state.scene, now);
}

void draw_costs(const ViewState& state, LiveSea& sea) {
  ImGui::Separator();
  if (const std::optional<world::CloudProgress> progress = sea.clouds_progress()) {
    const std::string text = fmt::format("{} of {} clouds", progress->done, progress->all);
    const auto all = static_cast<float>(std::max<std::size_t>(progress->all, 1));
    ImGui::ProgressBar((static_cast<float>(progress->done) + static_cast<float>(progress->share)) / all,
                       ImVec2(-1.0f, 0.0f), text.c_str());
  } else {
    ImGui::TextDisabled("all clouds are made");
  }
  if (sea.clouds() == nullptr) return;
  ImGui::Text("clouds: %zu; particles: %u", sea.clouds()->parameters().clouds.size(),
              sea.clouds()->whole_count());
  ImGui::Text("clouds take %.2f ms of a frame", sea.frame().times().mean_ms(Stage::clouds, TimeSource::cpu));
  if (state.clouds.picked.empty()) return;
  const auto& particles = sea.clouds()->parameters().particles;
  const std::size_t cloud = state.clouds.picked.back().cloud;
  if (cloud < particles.size() && particles[cloud])
    ImGui::Text("%zu of the picked cloud before edits", particles[cloud]->size());
}

/// A cloud is selected, or clicks make clouds or pick parts of them.
bool is_wanted(const ViewState& state) {
  const CloudEditing& editing = state.clouds;
  if (editing.tool != CloudTool::pick) return true;
  if (!state.scene.has_clouds()) return false;
  if (editing.pick == CloudPick::balls || editing.pick == CloudPick::particles) return true;
  const std::optional<SceneObject> selected = selected_object(state);
  return selected && selected->kind == ObjectKind::cloud;
}

}  // namespace

Edit draw_cloud_panel(ViewState& state, LiveSea& sea) {
  CloudEditing& editing = state.clouds;
  forget_lost_picks(state);
  if (!is_wanted(state)) return Edit::none;
  state.layout.place_right();
  Edit edit = Edit::none;
  if (ImGui::Begin("Cloud editor", nullptr,
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
    ImGui::PushItemWidth(side_item_em * ImGui::GetFontSize());
    ImGui::PushTextWrapPos(side_text_em * ImGui::GetFontSize());
    draw_tools(editing);
    if (!editing.picked.empty()) edit = std::max(edit, draw_picked_part(state));
    if (!editing.particles.empty()) edit = std::max(edit, draw_picked_particles(state));
    edit = std::max(edit, draw_sun(state));
    draw_costs(state, sea);
    ImGui::PopTextWrapPos();
    ImGui::PopItemWidth();
  }
  state.layout.end_right();
  ImGui::End();
  return edit;
}

}  // namespace offing::present
