#include "present/panels/quit_dialog.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include "host/base/error.h"

namespace offing::present {

void QuitDialog::open() {
  unsaved_ = scenes_.unsaved();
  has_quit_ = unsaved_.empty();
}

void QuitDialog::save() {
  unsaved_.clear();
  try {
    scenes_.save_all();
    has_quit_ = true;
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
}

void QuitDialog::draw() {
  if (!is_open()) return;
  constexpr const char* title = "Save before quitting?";
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove)) {
    return;
  }
  const std::string text = fmt::format("Edits of {} are not saved.", fmt::join(unsaved_, ", "));
  ImGui::PushTextWrapPos(22.0f * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  const bool is_saved = ImGui::Button("save");
  ImGui::SameLine();
  const bool is_discarded = ImGui::Button("discard");
  ImGui::SameLine();
  const bool is_cancelled = ImGui::Button("cancel");
  if (is_saved) save();
  if (is_discarded) has_quit_ = true;
  if (is_cancelled) cancel();
  if (is_saved || is_discarded || is_cancelled) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace offing::present
