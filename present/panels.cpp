#include "present/panels.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "host/scene/parameter_table.h"
#include "present/key_bindings.h"
#include "present/parameter_widget.h"

namespace offing::present {
namespace {

using scene::ParameterGroup;

struct GroupPanel {
  ParameterGroup group;
  const char* title;
};
constexpr std::array<GroupPanel, 9> group_panels{
    {{ParameterGroup::wind, "Wind"},
     {ParameterGroup::sea, "Spectrum"},
     {ParameterGroup::grid, "Waves: choppiness, cascades, Gerstner"},
     {ParameterGroup::foam, "Foam"},
     {ParameterGroup::sun, "Sun"},
     {ParameterGroup::camera, "Camera"},
     {ParameterGroup::render, "Picture"},
     {ParameterGroup::world, "World"},
     {ParameterGroup::time, "Scene time"}}};

/// Whether simulations depend on these values.
bool is_of_sea(ParameterGroup group) {
  return group != ParameterGroup::sun && group != ParameterGroup::camera && group != ParameterGroup::render;
}

void draw_group(const GroupPanel& panel, ViewState& state, PanelEdits& edits) {
  if (!ImGui::CollapsingHeader(panel.title)) return;
  ImGui::PushItemWidth(ImGui::GetFontSize() * 11.0f);
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (row.group != panel.group) continue;
    std::string fault;
    const Edit edit = parameter_widget(state.scene, row, fault);
    if (!fault.empty()) state.message = fault;
    // A sea is made when a slider is let go: it takes a moment.
    if (is_of_sea(panel.group)) edits.is_sea_changed |= edit == Edit::done;
    if (panel.group == ParameterGroup::sun) edits.is_sun_changed |= edit != Edit::none;
  }
  ImGui::PopItemWidth();
}

void draw_time(ViewState& state) {
  if (ImGui::Button(state.clock.is_paused() ? "run" : "pause")) state.clock.toggle_pause();
  ImGui::SameLine();
  if (ImGui::Button("<")) state.clock.step(-1);
  ImGui::SameLine();
  if (ImGui::Button(">")) state.clock.step(1);
  ImGui::SameLine();
  ImGui::Text("%.2f s", state.clock.time_s());
  float scale = static_cast<float>(state.clock.scale());
  if (ImGui::SliderFloat("time scale", &scale, 1.0f / 64.0f, 64.0f, "%.3g", ImGuiSliderFlags_Logarithmic)) {
    state.clock.set_scale(scale);
  }
}

void draw_view(ViewState& state) {
  if (ImGui::BeginCombo("show", std::string(to_string(state.debug)).c_str())) {
    for (const DebugView view : all_debug_views) {
      if (ImGui::Selectable(std::string(to_string(view)).c_str(), view == state.debug)) state.debug = view;
    }
    ImGui::EndCombo();
  }
  bool is_wireframe = state.fill == Fill::wireframe;
  if (ImGui::Checkbox("wireframe", &is_wireframe)) state.fill = is_wireframe ? Fill::wireframe : Fill::solid;
  ImGui::SliderFloat("render scale", &state.render_scale, 0.1f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SliderFloat("limit, frames/s", &state.frame_limit_hz, 0.0f, 240.0f, "%.0f",
                     ImGuiSliderFlags_AlwaysClamp);
}

void draw_times(const ViewFacts& facts) {
  ImGui::Text("%.1f frames/s, %d x %d", facts.times.frames_per_second(), facts.width_px, facts.height_px);
  ImGui::TextDisabled("OpenGL: %s", facts.capabilities.renderer.c_str());
  ImGui::TextDisabled("OpenCL: %s", facts.device.name.c_str());
  ImGui::TextDisabled("transfer: %s", std::string(to_string(facts.transfer)).c_str());
  ImGui::TextDisabled("ms: CPU and, in brackets, the device's own clock");
  for (std::size_t i = 0; i < stage_count; ++i) {
    const auto stage = static_cast<Stage>(i);
    const auto& history = facts.times.cpu_ms(stage);
    const std::string text = fmt::format("{} {:.1f} [{:.1f}]", to_string(stage),
                                         facts.times.mean_cpu_ms(stage), facts.times.mean_device_ms(stage));
    ImGui::PlotLines(fmt::format("##{}", to_string(stage)).c_str(), history.data(),
                     static_cast<int>(history.size()), 0, text.c_str(), 0.0f,
                     std::max(1.0f, *std::max_element(history.begin(), history.end())),
                     ImVec2(ImGui::GetFontSize() * 16.0f, ImGui::GetFontSize() * 2.2f));
  }
}

void draw_help() {
  ImGui::Begin("Keys", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
  if (ImGui::BeginTable("keys", 2)) {
    const auto row = [](const char* name, const char* help) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(name);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(help);
    };
    for (const CameraControl& control : camera_controls()) row(control.name, control.help);
    for (const KeyBinding& binding : key_bindings()) row(binding.name, binding.help);
    ImGui::EndTable();
  }
  ImGui::End();
}

void draw_message(std::string& message) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0.0f, size.y), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(size.x, 0.5f * size.y));
  ImGui::Begin("Message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav);
  ImGui::PushTextWrapPos(size.x - 20.0f);
  ImGui::TextUnformatted(message.c_str());
  ImGui::PopTextWrapPos();
  if (ImGui::SmallButton("dismiss")) message.clear();
  ImGui::End();
}

}  // namespace

PanelEdits draw_panels(ViewState& state, const ViewFacts& facts) {
  PanelEdits edits;
  if (state.shows_panels) {
    state.scene.view.camera = state.camera.camera();
    ImGui::SetNextWindowPos(ImVec2(8.0f, 8.0f), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(ImVec2(ImGui::GetFontSize() * 24.0f, 0.0f), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(
        ImVec2(100.0f, 40.0f), ImVec2(10000.0f, std::max(80.0f, ImGui::GetIO().DisplaySize.y - 16.0f)));
    ImGui::Begin("Offing");
    draw_time(state);
    if (ImGui::CollapsingHeader("View")) draw_view(state);
    for (const GroupPanel& panel : group_panels) draw_group(panel, state, edits);
    if (ImGui::CollapsingHeader("Frame times")) draw_times(facts);
    ImGui::TextDisabled("H help, Tab panels");
    ImGui::End();
    state.camera.camera() = state.scene.view.camera;
  }
  if (state.shows_help) draw_help();
  if (!state.message.empty()) draw_message(state.message);
  return edits;
}

}  // namespace offing::present
