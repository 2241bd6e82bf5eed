#include "present/panels/scene_list_panel.h"

#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

namespace offing::present {
namespace {

/// Names can hold what ImGui takes for the end of a label: they are text beside a row without one.
std::optional<ListedScene> draw_part(const char* id, const std::vector<ListedScene>& scenes,
                                     const ListedScene& open) {
  constexpr float most_rows = 10.0f;
  const float row_px = ImGui::GetTextLineHeightWithSpacing();
  const float height_px = row_px * std::min(static_cast<float>(scenes.size()), most_rows) +
                          2.0f * ImGui::GetStyle().WindowPadding.y;
  std::optional<ListedScene> clicked;
  ImGui::BeginChild(id, ImVec2(0.0f, height_px), true);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable("##scene", scenes[i] == open)) clicked = scenes[i];
    ImGui::SameLine(ImGui::GetStyle().FramePadding.x);
    ImGui::TextUnformatted(scenes[i].name.c_str());
    ImGui::PopID();
  }
  ImGui::EndChild();
  return clicked;
}

}  // namespace

std::optional<ListedScene> draw_scene_list(SceneList& list, const ListedScene& open) {
  // Unfolding is what ImGui tells as a toggle of the header.
  const bool is_unfolded = ImGui::CollapsingHeader("Scenes");
  if (ImGui::IsItemToggledOpen() && is_unfolded) list.look();
  if (!is_unfolded) return {};
  std::optional<ListedScene> clicked;
  if (!list.beside().empty()) {
    const std::string folder = list.folder().empty() ? "here" : "in " + list.folder().string();
    ImGui::TextDisabled("%s", folder.c_str());
    clicked = draw_part("beside", list.beside(), open);
  }
  ImGui::TextDisabled("with Offing");
  const std::optional<ListedScene> shipped = draw_part("shipped", list.shipped(), open);
  return shipped ? shipped : clicked;
}

}  // namespace offing::present
