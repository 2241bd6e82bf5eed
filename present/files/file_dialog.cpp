#include "present/files/file_dialog.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"
#include "host/io/file_presence.h"
#include "present/panels/imgui_versions.h"
#include "present/panels/look.h"
#include "present/panels/panel_layout.h"

namespace offing::present {
namespace {

/// "cliffs/" of a folder, so that it is told from a file.
std::string shown_entry(const FileEntry& entry) {
  return entry.is_folder ? entry.name + "/" : entry.name;
}

/// Where the columns of size and time begin, from the left edge of a list; 0 if it is too narrow for them.
struct EntryColumns {
  float size_px = 0.0f, time_px = 0.0f;
};
EntryColumns entry_columns(float width) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float em = ImGui::GetFontSize();
  const float time = ImGui::CalcTextSize("0000-00-00 00:00").x, size = ImGui::CalcTextSize("000 MB").x;
  const float time_px = width - time - style.ScrollbarSize - style.WindowPadding.x;
  const float size_px = time_px - size - em;
  constexpr float least_name_em = 10.0f;
  return size_px < least_name_em * em ? EntryColumns{} : EntryColumns{size_px, time_px};
}

/// Size and time in the row of the last item, over the end of a name that is too long.
void draw_facts(const FileEntry& entry, const EntryColumns& columns) {
  if (columns.size_px <= 0.0f || entry.name == "..") return;
  const ImVec2 low = ImGui::GetItemRectMin();
  const float left = ImGui::GetWindowPos().x, end = left + ImGui::GetWindowWidth();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize();
  if (ImGui::GetItemRectMax().x > left + columns.size_px - 0.5f * em) {
    list.AddRectFilled({left + columns.size_px - 0.5f * em, low.y}, {end, low.y + ImGui::GetTextLineHeight()},
                       ImGui::GetColorU32(ImGuiCol_PopupBg, 1.0f));
  }
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  if (entry.bytes) list.AddText({left + columns.size_px, low.y}, colour, shown_size(*entry.bytes).c_str());
  list.AddText({left + columns.time_px, low.y}, colour, shown_time(entry.written).c_str());
}

/// A row of a list. Names can hold what ImGui takes for the end of a label: they are text beside a row
/// without one.
bool list_row(const char* label, std::size_t number, std::string_view text, bool is_chosen) {
  ImGui::PushID(static_cast<int>(number));
  const bool is_clicked = ImGui::Selectable(
      label, is_chosen, ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
  ImGui::SameLine(ImGui::GetStyle().FramePadding.x);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopID();
  return is_clicked;
}

}  // namespace

void FileDialog::open(const Request& request) {
  request_ = request;
  is_open_ = true;
  name_ = request.name;
  asked_.clear();
  new_folder_.reset();
  browser_ = {};
  browser_.set_filter(request.filter);
  go_to(request.folder);
  std::erase_if(request_.recent, [&](const auto& file) { return !passes(request.filter, file); });
}

void FileDialog::for_shown_names(const std::function<void(std::string_view)>& tell) const {
  if (!is_open_) return;
  tell(folder_text_);
  tell(name_);
  tell(fault_);
  for (const FileEntry& entry : browser_.entries()) tell(entry.name);
  for (const std::filesystem::path& file : request_.recent) tell(file.string());
}

void FileDialog::go_to(const std::filesystem::path& folder) {
  fault_.clear();
  if (!browser_.go_to(folder)) fault_ = fmt::format("{}: cannot be read", one_line(folder.string()));
  folder_text_ = browser_.folder().string();
  focuses_name_ = scrolls_ = true;
}

std::optional<std::string> FileDialog::name_beside(int step) const {
  const std::vector<FileEntry>& entries = browser_.entries();
  if (entries.empty()) return {};
  const auto now = std::ranges::find(entries, name_, shown_entry);
  const int last = static_cast<int>(entries.size()) - 1;
  int next = step > 0 ? 0 : last;
  if (now != entries.end()) next = std::clamp(static_cast<int>(now - entries.begin()) + step, 0, last);
  return shown_entry(entries[static_cast<std::size_t>(next)]);
}

void FileDialog::accept() {
  fault_.clear();
  if (name_.empty()) {
    if (is_of_folders()) chosen_ = {.file = browser_.folder(), .purpose = request_.purpose};
    return;
  }
  const std::filesystem::path file = browser_.at(name_);
  try {
    if (is_folder_to_enter(file)) {
      go_to(file);
      name_ = request_.name;
    } else if (is_saving()) {
      accept_to_save(file);
    } else if (is_there(file)) {
      // Any file of a folder names it.
      chosen_ = {.file = is_of_folders() ? file.parent_path() : file, .purpose = request_.purpose};
    } else {
      fault_ = fmt::format("there is no file {}", one_line(file.string()));
    }
  } catch (const Error& error) {
    fault_ = error.what();
  }
}

void FileDialog::accept_to_save(std::filesystem::path file) {
  if (lower_extension(file) != ".toml") file += ".toml";
  std::error_code unknown;
  if (!std::filesystem::is_directory(file.parent_path(), unknown)) {
    fault_ = fmt::format("there is no folder {}", one_line(file.parent_path().string()));
  } else if (is_taken(file)) {
    asked_ = file;
    answers_replace_ = false;
  } else {
    chosen_ = {.file = file, .purpose = FilePurpose::save_scene};
  }
}

std::optional<ChosenFile> FileDialog::draw() {
  const char* title = is_saving()       ? "Save scene as###file dialog"
                      : is_of_folders() ? "Choose a folder###file dialog"
                                        : "Open a file###file dialog";
  if (is_open_ && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(screen.x - em, 50.0f * em), std::min(screen.y - em, 34.0f * em)));
  constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
  if (!ImGui::BeginPopupModal(title, nullptr, fixed)) return {};
  has_list_ = new_folder_.has_value();
  const bool asks = !asked_.empty();
  ImGui::BeginDisabled(asks);
  draw_folder();
  const float below =
      (asks ? 3.0f : 2.0f) * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
  const float height = std::max(4.0f * em, ImGui::GetContentRegionAvail().y - below);
  const float places = std::min(14.0f * em, 0.35f * ImGui::GetContentRegionAvail().x);
  ImGui::BeginChild("places", ImVec2(places, height), true);
  draw_places();
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginGroup();
  draw_head();
  ImGui::BeginChild("entries", ImVec2(0.0f, height - ImGui::GetTextLineHeightWithSpacing()), true);
  draw_entries();
  ImGui::EndChild();
  ImGui::EndGroup();
  draw_name();
  ImGui::EndDisabled();
  if (asks) {
    draw_answers();
  } else if (!has_list_ && !new_folder_) {
    if (is_pressed(ImGuiKey_Escape)) is_open_ = false;
    if (!ImGui::IsAnyItemActive()) focuses_name_ = true;
  }
  if (chosen_) is_open_ = false;
  if (!is_open_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return std::exchange(chosen_, {});
}

void FileDialog::draw_folder() {
  if (new_folder_) return draw_new_folder();
  if (ImGui::Button("up")) go_to("..");
  ImGui::SameLine();
  if (is_saving() || is_of_folders()) {
    if (ImGui::Button("new folder")) new_folder_.emplace();
    ImGui::SameLine();
  }
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::InputText("##folder", &folder_text_, ImGuiInputTextFlags_EnterReturnsTrue)) return;
  go_to(browser_.at(folder_text_));
}

/// A field for the name of a new folder, in place of the path. Enter makes the folder, Esc gives up.
void FileDialog::draw_new_folder() {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("new folder");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  const bool is_entered = ImGui::InputTextWithHint("##new folder", "its name", &*new_folder_,
                                                   ImGuiInputTextFlags_EnterReturnsTrue);
  if (is_entered && !new_folder_->empty()) {
    const std::filesystem::path folder = browser_.at(*new_folder_);
    std::error_code failure;
    std::filesystem::create_directory(folder, failure);
    go_to(folder);
    if (failure) fault_ = fmt::format("{}: {}", one_line(folder.string()), failure.message());
  }
  if (is_entered || is_pressed(ImGuiKey_Escape)) {
    new_folder_.reset();
    focuses_name_ = true;
  }
}

/// Buttons above the list, which sort it.
void FileDialog::draw_head() {
  const EntryColumns columns = entry_columns(ImGui::GetContentRegionAvail().x);
  const float left = ImGui::GetCursorPosX();
  const auto head = [&](const char* label, float at, FileOrder order) {
    ImGui::SetCursorPosX(left + at);
    const bool is_chosen = browser_.order() == order;
    if (!is_chosen) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    const bool is_clicked = ImGui::Selectable(label, false, ImGuiSelectableFlags_DontClosePopups,
                                              ImVec2(ImGui::CalcTextSize(label, nullptr, true).x, 0.0f));
    if (!is_chosen) ImGui::PopStyleColor();
    if (is_clicked) browser_.set_order(order);
  };
  head("name##order", ImGui::GetStyle().FramePadding.x, FileOrder::name);
  if (columns.size_px <= 0.0f) return;
  ImGui::SameLine();
  head("size##order", columns.size_px, FileOrder::size);
  ImGui::SameLine();
  head("changed##order", columns.time_px, FileOrder::time);
}

void FileDialog::draw_places() {
  std::size_t number = 0;
  const auto place = [&](const char* name, const std::filesystem::path& folder) {
    if (list_row("##place", number++, name, folder == browser_.folder())) go_to(folder);
    if (ImGui::IsItemHovered()) explain_item(folder.string());
  };
  if (const char* home = std::getenv("HOME")) place("home", home);
  std::error_code unknown;
  place("here", std::filesystem::current_path(unknown));
  if (!request_.folder.empty()) place("scene's folder", request_.folder);
  place("computer", "/");
  if (request_.recent.empty()) return;
  ImGui::Spacing();
  ImGui::TextDisabled("recent");
  for (std::size_t i = 0; i < request_.recent.size(); ++i) {
    const std::filesystem::path& file = request_.recent[i];
    if (list_row("##recent", i, file.filename().string(), name_ == file.string())) {
      name_ = file.string();
      focuses_name_ = true;
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) accept();
    }
    if (ImGui::IsItemHovered()) explain_item(file.string());
  }
}

void FileDialog::draw_entries() {
  // What a double click enters is another list.
  const std::vector<FileEntry> entries = browser_.entries();
  const EntryColumns columns = entry_columns(ImGui::GetWindowWidth());
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries.size()));
  const auto chosen = std::ranges::find(entries, name_, shown_entry);
  if (std::exchange(scrolls_, false)) {
    const float row_px = ImGui::GetTextLineHeightWithSpacing();
    const auto number = chosen == entries.end() ? 0 : chosen - entries.begin();
    ImGui::SetScrollY(std::max(0.0f, static_cast<float>(number) * row_px - 0.5f * ImGui::GetWindowHeight()));
  }
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const FileEntry& entry = entries[static_cast<std::size_t>(i)];
      const std::string name = shown_entry(entry);
      const bool is_clicked = list_row("##entry", static_cast<std::size_t>(i), name, name == name_);
      draw_facts(entry, columns);
      if (!is_clicked) continue;
      name_ = name;
      focuses_name_ = true;
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) accept();
    }
  }
}

void FileDialog::draw_name() {
  const auto on_arrow = [](ImGuiInputTextCallbackData* data) {
    FileDialog& dialog = *static_cast<FileDialog*>(data->UserData);
    const std::optional<std::string> name = dialog.name_beside(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
    if (!name) return 0;
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, name->c_str());
    dialog.scrolls_ = true;
    return 0;
  };
  const float kinds = 12.0f * ImGui::GetFontSize();
  ImGui::SetNextItemWidth(-(kinds + ImGui::GetStyle().ItemSpacing.x));
  if (asked_.empty() && std::exchange(focuses_name_, false)) ImGui::SetKeyboardFocusHere();
  const bool is_entered = ImGui::InputText(
      "##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory, on_arrow,
      this);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1.0f);
  const auto shown = static_cast<std::size_t>(browser_.filter());
  if (ImGui::BeginCombo("##filter", file_filter_names[shown])) {
    has_list_ = true;
    for (std::size_t i = 0; i < file_filter_names.size(); ++i) {
      if (ImGui::Selectable(file_filter_names[i], i == shown))
        browser_.set_filter(static_cast<FileFilter>(i));
    }
    if (is_pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
  }
  const bool is_confirmed = ImGui::Button(is_saving()                        ? "save"
                                          : is_of_folders() && name_.empty() ? "take this folder"
                                                                             : "open");
  ImGui::SameLine();
  if (ImGui::Button("cancel")) is_open_ = false;
  ImGui::PushStyleColor(ImGuiCol_Text, fault_colour());
  ImGui::TextUnformatted(fault_.c_str());
  ImGui::PopStyleColor();
  if (asked_.empty() && (is_entered || is_confirmed)) accept();
}

void FileDialog::draw_answers() {
  ImGui::Text("%s exists already.", one_line(asked_.filename().string()).c_str());
  const auto answer = [&](const char* label, bool is_chosen) {
    if (is_chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    const bool is_clicked = ImGui::Button(label);
    if (is_chosen) ImGui::PopStyleColor();
    return is_clicked || (is_chosen && is_pressed(ImGuiKey_Enter));
  };
  const bool is_other = answer("another name", !answers_replace_);
  ImGui::SameLine();
  const bool is_replaced = answer("replace it", answers_replace_);
  if (is_pressed(ImGuiKey_LeftArrow) || is_pressed(ImGuiKey_RightArrow)) answers_replace_ = !answers_replace_;
  if (is_replaced) {
    chosen_ = {.file = asked_, .purpose = FilePurpose::save_scene, .existing = Existing::replace};
  } else if (is_other || is_pressed(ImGuiKey_Escape)) {
    asked_.clear();
    focuses_name_ = true;
  }
}

}  // namespace offing::present
