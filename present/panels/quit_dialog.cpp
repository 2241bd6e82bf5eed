#include "present/panels/quit_dialog.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include "host/base/error.h"

namespace offing::present {

void QuitDialog::open(const std::optional<RecordingProgress>& recording) {
  unsaved_ = scenes_.unsaved();
  is_open_ = !unsaved_.empty() || recording;
  has_quit_ = !is_open_;
}

void QuitDialog::quit() {
  is_open_ = false;
  has_quit_ = true;
}

void QuitDialog::save() {
  is_open_ = false;
  try {
    if (!unsaved_.empty()) scenes_.save_all();
    quit();
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
}

void QuitDialog::draw(const std::optional<RecordingProgress>& recording) {
  if (!is_open()) return;
  const bool has_unsaved = !unsaved_.empty();
  const char* title = has_unsaved ? "Save before quitting?###quit" : "End the recording and quit?###quit";
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove)) {
    return;
  }
  ImGui::PushTextWrapPos(22.0f * ImGui::GetFontSize());
  if (has_unsaved)
    ImGui::TextUnformatted(fmt::format("Unsaved edits: {}.", fmt::join(unsaved_, ", ")).c_str());
  if (recording) {
    ImGui::Text("A recording runs: %d of %d frames. Quitting ends it.", recording->written, recording->count);
  }
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  const bool is_saved = has_unsaved && ImGui::Button("save");
  if (has_unsaved) ImGui::SameLine();
  const bool is_discarded = ImGui::Button(has_unsaved ? "discard" : "quit") || (!has_unsaved && !recording);
  ImGui::SameLine();
  const bool is_cancelled = ImGui::Button("cancel");
  if (is_saved) save();
  if (is_discarded) quit();
  if (is_cancelled) cancel();
  if (!is_open()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace offing::present
