#include "present/panels/panel_layout.h"

#include <algorithm>
#include <utility>

#include <imgui.h>

#include "present/panels/look.h"

namespace offing::present {
namespace {

// Of a panel for which there is no room left.
constexpr float least_height_em = 8.0f;

ImVec2 screen_px() {
  return ImGui::GetIO().DisplaySize;
}

}  // namespace

float PanelLayout::margin() {
  return 0.5f * ImGui::GetFontSize();
}

void PanelLayout::begin() {
  main_px_ = margin();
  right_px_ = margin();
  low_px_ = std::exchange(next_low_px_, 0.0f);
  low_left_px_ = std::exchange(next_low_left_px_, 0.0f);
  right_begin_px_ = std::exchange(next_right_begin_px_, screen_px().x);
  timeline_px_ = std::exchange(next_timeline_px_, 0.0f);
}

/// Or the window's bottom without a timeline.
float PanelLayout::timeline_top() const {
  return screen_px().y - timeline_px_;
}

/// Of panels above the timeline.
float PanelLayout::bottom() const {
  return std::max(least_height_em * ImGui::GetFontSize(), timeline_top() - margin());
}

FreeWidth PanelLayout::free_width() const {
  constexpr float least_share = 0.2f;
  const float width = screen_px().x;
  if (right_begin_px_ - main_px_ < least_share * width) return {};
  const auto clip = [&](float px) { return 2.0 * static_cast<double>(px / width) - 1.0; };
  return {clip(main_px_), clip(right_begin_px_)};
}

void PanelLayout::place_main(float width_em) {
  const float width = std::min(width_em * ImGui::GetFontSize(), screen_px().x - 2.0f * margin());
  main_px_ = margin() + width;
  ImGui::SetNextWindowPos(ImVec2(margin(), margin()));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));               // as high as what it holds
  const float least = least_height_em * ImGui::GetFontSize();  // which the values need
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f),
                                      ImVec2(width, std::max(0.5f * least, bottom() - margin() - least)));
}

float PanelLayout::main_room() const {
  return bottom() - ImGui::GetCursorScreenPos().y;
}

void PanelLayout::end_main() {
  main_end_px_ = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
}

void PanelLayout::place_values() const {
  const float width = main_px_ - margin(), least = least_height_em * ImGui::GetFontSize();
  const float top = std::min(main_end_px_, bottom() - least);
  ImGui::SetNextWindowPos(ImVec2(margin(), top));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, bottom() - top));
}

float PanelLayout::draw_main_edge(float width_em) {
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(ImVec2(main_px_, margin()));
  ImGui::SetNextWindowSize(ImVec2(margin(), bottom() - margin()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
  ImGui::Begin("panel edge", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::InvisibleButton("edge", ImVec2(margin(), bottom() - margin()));
  const bool is_held = ImGui::IsItemActive();
  if (is_held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (is_held) width_em = (ImGui::GetIO().MousePos.x - 1.5f * margin()) / em;
  ImGui::End();
  ImGui::PopStyleVar(2);
  const float most_em = std::min(most_panel_em, (screen_px().x - 3.0f * margin()) / em);
  return is_held ? std::clamp(width_em, least_panel_em, std::max(least_panel_em, most_em)) : width_em;
}

void PanelLayout::place_right() {
  const float em = ImGui::GetFontSize(), free_px = bottom() - low_px_ - right_px_;
  const float height = std::max(least_height_em * em, free_px);
  const float top = std::min(right_px_, std::max(margin(), bottom() - height));
  ImGui::SetNextWindowPos(ImVec2(screen_px().x - margin(), top), ImGuiCond_Always, ImVec2(1.0f, 0.0f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(right_width(), height));
}

float PanelLayout::right_width() const {
  constexpr float least_em = 20.0f;
  const float width = std::max(least_em * ImGui::GetFontSize(), screen_px().x - main_px_ - 3.0f * margin());
  return std::min(width, screen_px().x - 2.0f * margin());
}

void PanelLayout::end_right() {
  next_right_begin_px_ = std::min(next_right_begin_px_, ImGui::GetWindowPos().x);
  right_px_ = ImGui::GetWindowPos().y + ImGui::GetWindowHeight() + margin();
}

void PanelLayout::place_low_left() const {
  ImGui::SetNextWindowPos(ImVec2(main_px_ + 2.0f * margin(), bottom()), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
}

void PanelLayout::place_low_right() const {
  ImGui::SetNextWindowPos(ImVec2(screen_px().x - margin(), bottom()), ImGuiCond_Always, ImVec2(1.0f, 1.0f));
}

void PanelLayout::end_low_left() {
  next_low_left_px_ = ImGui::GetWindowHeight() + margin();
  next_low_px_ = std::max(next_low_px_, next_low_left_px_);
}

void PanelLayout::end_low_right() {
  next_low_px_ = std::max(next_low_px_, ImGui::GetWindowHeight() + margin());
  next_right_begin_px_ = std::min(next_right_begin_px_, ImGui::GetWindowPos().x);
}

void PanelLayout::place_timeline() const {
  const float width = screen_px().x - 2.0f * margin();
  ImGui::SetNextWindowPos(ImVec2(margin(), screen_px().y - margin()), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
}

void PanelLayout::end_timeline() {
  next_timeline_px_ = ImGui::GetWindowHeight() + margin();
}

void PanelLayout::place_message() const {
  const float left = main_px_ + 2.0f * margin();
  ImGui::SetNextWindowPos(ImVec2(left, bottom() - low_left_px_), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(message_width(), 0.5f * screen_px().y));
}

float PanelLayout::message_width() const {
  constexpr float least_em = 14.0f;  // where there is less room it lies over the panels at the right
  const float left = main_px_ + 2.0f * margin(), most = std::max(1.0f, screen_px().x - left - margin());
  const float room = right_begin_px_ - left - margin();
  return std::min(most, std::max(room, least_em * ImGui::GetFontSize()));
}

void explain_item(std::string_view help) {
  if (!ImGui::IsItemHovered()) return;
  constexpr float least_em = 14.0f, most_em = 36.0f;  // of its text
  const float em = ImGui::GetFontSize(), gap = PanelLayout::margin();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(), screen = screen_px();
  const float padding = 2.0f * ImGui::GetStyle().WindowPadding.x, beside = 2.0f * gap + padding;
  const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth();
  const bool is_low = low.y > 0.5f * screen.y;
  float room = screen.x - right - beside;
  if (room >= least_em * em) {
    ImGui::SetNextWindowPos({right + gap, is_low ? high.y : low.y}, 0, {0.0f, is_low ? 1.0f : 0.0f});
  } else if (left - beside >= least_em * em) {
    room = left - beside;
    ImGui::SetNextWindowPos({left - gap, is_low ? high.y : low.y}, 0, {1.0f, is_low ? 1.0f : 0.0f});
  } else {
    room = screen.x - beside;
    const float begin =
        std::max(gap, std::min(low.x, screen.x - gap - std::min(room, most_em * em) - padding));
    ImGui::SetNextWindowPos({begin, is_low ? low.y - gap : high.y + gap}, 0, {0.0f, is_low ? 1.0f : 0.0f});
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(std::min(room, most_em * em));
  ImGui::TextUnformatted(help.data(), help.data() + help.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void stay_in_line(const char* label) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float width = ImGui::CalcTextSize(label, nullptr, true).x + 2.0f * style.FramePadding.x;
  if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= end) ImGui::SameLine();
}

}  // namespace offing::present
