#include "present/timeline/record_dialog.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "host/base/error.h"
#include "host/scene/prepare/scene_renderer.h"
#include "present/files/file_browser.h"
#include "present/output/video_pipe.h"
#include "present/panels/imgui_versions.h"
#include "present/panels/look.h"
#include "present/panels/panel_layout.h"

namespace offing::present {
namespace {

bool is_video(RecordFormat format) {
  return format == RecordFormat::mp4 || format == RecordFormat::webm;
}

const char* name_ending_of(RecordFormat format) {
  constexpr std::array<const char*, 4> endings{".mp4", ".webm", "_%04d.png", "_%04d.exr"};
  return endings[static_cast<std::size_t>(format)];
}

}  // namespace

Recording recording_of(const RecordingRequest& request) {
  constexpr double last_frame = 9'999'999.0;  // as --frames takes them
  constexpr double lowest_hz = 0.001, highest_hz = 1e6;
  if (!(request.frames_per_second >= lowest_hz && request.frames_per_second <= highest_hz)) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("expected {:g} to {:g} frames/s, found {:g}", lowest_hz, highest_hz,
                            request.frames_per_second),
                "films have 24 frames/s");
  }
  const double first = std::ceil(request.start_s * request.frames_per_second - 1e-9) + 0.0;  // + 0: never -0
  const double last = first + std::round(request.seconds * request.frames_per_second) - 1.0;
  if (!(first >= 0.0 && last >= first && last <= last_frame)) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("expected frames 0 to {:.0f}, found {:.0f} to {:.0f}", last_frame, first, last),
                "record more than 0 s, and start at 0 s or later");
  }
  std::filesystem::path file = std::filesystem::absolute(FileBrowser().at(request.name));
  if (!is_video(request.format) && request.has_folder) file /= file.filename();
  const std::string name = file.string() + name_ending_of(request.format);
  Recording recording{.frames = {static_cast<int>(first), static_cast<int>(last)},
                      .frames_per_second = request.frames_per_second,
                      .existing = request.replaces ? Existing::replace : Existing::keep};
  if (is_video(request.format)) {
    recording.video = name;
  } else {
    recording.name.emplace("name", name, "out_%04d.png");
  }
  return recording;
}

std::string unused_record_name(const std::string& stem) {
  std::error_code failed;
  std::vector<std::string> names;
  for (std::filesystem::directory_iterator entry(".", failed), end; !failed && entry != end;
       entry.increment(failed))
    names.push_back(entry->path().filename().string());
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}_{:03}", stem, number);
    if (std::ranges::none_of(names, [&](const std::string& taken) { return taken.starts_with(name); }))
      return name;
  }
}

void RecordDialog::open(const RecordingRequest& request) {
  request_ = request;
  fault_.clear();
  folders_.close();
  is_open_ = focuses_seconds_ = true;
}

void RecordDialog::for_shown_names(const std::function<void(std::string_view)>& tell) const {
  tell(request_.name);
  tell(fault_);
  folders_.for_shown_names(tell);
}

void RecordDialog::draw_format() {
  const auto shown = static_cast<std::size_t>(request_.format);
  if (!ImGui::BeginCombo("format", record_format_names[shown])) return;
  has_list_ = true;
  for (std::size_t i = 0; i < record_format_names.size(); ++i) {
    const bool is_possible = !is_video(static_cast<RecordFormat>(i)) || has_ffmpeg();
    if (!is_possible) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    const bool is_chosen = ImGui::Selectable(record_format_names[i], i == shown);
    if (!is_possible) ImGui::PopStyleColor();
    if (!is_chosen) continue;
    request_.format = static_cast<RecordFormat>(i);
    fault_.clear();
    if (!is_possible)
      fault_ = "videos need the program ffmpeg, which is not on PATH: install it, or record pictures";
  }
  if (is_pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
  ImGui::EndCombo();
}

void RecordDialog::draw_size(ImageSize window) {
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest_px_);
  longest_px_ = std::min(longest_px_, scene::longest_picture_px);
  std::array<int, 2> sides{request_.size.width, request_.size.height};
  if (ImGui::InputInt2("width, height", sides.data()))
    request_.size = {std::max(sides[0], 1), std::max(sides[1], 1)};
  struct Usual {
    const char* label;
    ImageSize size;
  };
  const std::array<Usual, 4> all{
      {{"720p", {1280, 720}}, {"1080p", {1920, 1080}}, {"2160p", {3840, 2160}}, {"window", window}}};
  for (const Usual& usual : all) {
    if (&usual != &all.front()) ImGui::SameLine();
    if (ImGui::SmallButton(usual.label)) request_.size = usual.size;
    explain_item(fmt::format("{} x {}", usual.size.width, usual.size.height));
  }
}

void RecordDialog::draw_range(double now_s) {
  if (std::exchange(focuses_seconds_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::InputDouble("seconds", &request_.seconds, 0.0, 0.0, "%.6g");
  ImGui::TextDisabled(request_.has_path ? "the camera follows its keyframes"
                                        : "the camera stays where it is now");
  ImGui::InputDouble("start, s", &request_.start_s, 0.0, 0.0, "%.6g");
  ImGui::SameLine();
  if (ImGui::SmallButton("now")) request_.start_s = now_s;
  explain_item("start at the time that the window shows");
  ImGui::InputDouble("frames/s", &request_.frames_per_second, 0.0, 0.0, "%.6g");
}

void RecordDialog::draw_name() {
  ImGui::InputText("name", &request_.name);
  if (!is_video(request_.format)) {
    ImGui::Checkbox("in a folder of this name", &request_.has_folder);
    explain_item("keeps pictures apart from other files; the folder is made if there is none");
  }
  try {
    const Recording recording = recording_of(request_);
    const std::string first =
        (recording.name ? recording.name->of(recording.frames.first) : recording.video).string();
    ImGui::TextDisabled("%d frames: %d to %d", recording.count(), recording.frames.first,
                        recording.frames.last);
    ImGui::TextDisabled("%s%s", first.c_str(), recording.name ? " ..." : "");
  } catch (const Error& error) {
    ImGui::TextDisabled("%s", error.what());
  }
  const std::filesystem::path chosen = FileBrowser().at(request_.name);
  if (ImGui::Button("folder ...")) {
    folders_.open({.purpose = FilePurpose::folder_value,
                   .filter = FileFilter::pictures,
                   .folder = chosen.parent_path(),
                   .name = {},
                   .recent = {}});
  }
  explain_item("choose where to write");
  if (const std::optional<ChosenFile> folder = folders_.draw())
    request_.name = (folder->file / chosen.filename()).string();
  ImGui::SameLine();
  ImGui::Checkbox("replace existing files", &request_.replaces);
}

bool RecordDialog::draw(ImageSize window, double now_s) {
  constexpr const char* title = "Record###record dialog";
  if (is_open_ && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  const float width = std::min(screen.x - em, 32.0f * em);
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, screen.y - em));
  constexpr ImGuiWindowFlags fixed =
      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;
  if (!ImGui::BeginPopupModal(title, nullptr, fixed)) return false;
  has_list_ = folders_.is_open();
  ImGui::PushItemWidth(width - 10.0f * em);
  ImGui::PushTextWrapPos(width - em);
  draw_range(now_s);
  draw_format();
  draw_size(window);
  bool is_high = request_.detail == Detail::high;
  if (ImGui::Checkbox("high detail", &is_high)) request_.detail = is_high ? Detail::high : Detail::low;
  explain_item("full detail of water and ground; without it, coarser, and faster where the CPU draws");
  draw_name();
  ImGui::PushStyleColor(ImGuiCol_Text, fault_colour());
  if (!fault_.empty()) ImGui::TextUnformatted(fault_.c_str());
  ImGui::PopStyleColor();
  bool is_wanted = ImGui::Button("record");
  ImGui::SameLine();
  if (ImGui::Button("cancel")) is_open_ = false;
  if (!has_list_ && is_pressed(ImGuiKey_Enter)) is_wanted = true;
  if (!has_list_ && is_pressed(ImGuiKey_Escape)) is_open_ = is_wanted = false;
  ImGui::PopTextWrapPos();
  ImGui::PopItemWidth();
  if (is_wanted) fault_.clear();
  if (is_wanted && std::max(request_.size.width, request_.size.height) > longest_px_) {
    is_wanted = false;
    refuse(fmt::format("expected at most {} pixels for width and height on this device, found {} x {}",
                       longest_px_, request_.size.width, request_.size.height));
  }
  if (!is_open_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return is_wanted && is_open_;
}

}  // namespace offing::present
