#include "present/panels/time_graph.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

namespace offing::present {
namespace {

// Told apart also by those who do not see red and green (Okabe & Ito 2008).
constexpr std::array<ImU32, stage_count> colours{
    IM_COL32(86, 180, 233, 255),  IM_COL32(213, 94, 0, 255),    IM_COL32(230, 159, 0, 255),
    IM_COL32(240, 228, 66, 255),  IM_COL32(0, 114, 178, 255),   IM_COL32(190, 190, 190, 255),
    IM_COL32(250, 250, 250, 255), IM_COL32(204, 121, 167, 255), IM_COL32(0, 158, 115, 255)};

/// The graph's upper end: round, and above all but single frames that stood still.
float scale_ms(const StageTimes& times, TimeSource source) {
  std::array<float, StageTimes::history_length> sums{};
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    const auto& history = times.history_ms(static_cast<Stage>(stage), source);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += history[i];
  }
  std::sort(sums.begin(), sums.end());
  const float usual = sums[sums.size() * 19 / 20];
  float scale = 10.0f;
  while (scale < 1.1f * usual) scale *= 2.0f;
  return scale;
}

void draw_columns(const StageTimes& times, TimeSource source) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 6.0f * ImGui::GetFontSize());
  const ImVec2 end(origin.x + size.x, origin.y + size.y);
  const float scale = scale_ms(times, source), column = size.x / StageTimes::history_length;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(origin, end, true);
  list.AddRectFilled(origin, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
  for (std::size_t frame = 0; frame < StageTimes::history_length; ++frame) {
    const float x = origin.x + column * static_cast<float>(frame);
    float y = end.y;
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
      const float height = size.y * times.history_ms(static_cast<Stage>(stage), source)[frame] / scale;
      if (height <= 0.0f) continue;
      list.AddRectFilled(ImVec2(x, y - height), ImVec2(x + column, y), colours[stage]);
      y -= height;
    }
  }
  const std::string top = fmt::format("{:.0f} ms", scale);
  list.AddText(ImVec2(origin.x + 3.0f, origin.y + 1.0f), ImGui::GetColorU32(ImGuiCol_Text), top.c_str());
  list.PopClipRect();
  ImGui::Dummy(size);
}

}  // namespace

void draw_time_graph(const StageTimes& times, TimeSource source) {
  draw_columns(times, source);
  if (!ImGui::BeginTable("stages", 3)) return;
  ImGui::TableSetupColumn("stage");
  ImGui::TableSetupColumn("CPU, ms");
  ImGui::TableSetupColumn("device, ms");
  ImGui::TableHeadersRow();
  for (std::size_t i = 0; i < stage_count; ++i) {
    const auto stage = static_cast<Stage>(i);
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colours[i]);
    ImGui::Bullet();
    ImGui::PopStyleColor();
    ImGui::TextUnformatted(to_string(stage).data());
    for (const TimeSource one : {TimeSource::cpu, TimeSource::device}) {
      ImGui::TableNextColumn();
      ImGui::Text("%.2f", times.mean_ms(stage, one));
    }
  }
  ImGui::EndTable();
}

}  // namespace offing::present
