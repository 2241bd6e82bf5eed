#include "present/timeline/timeline_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "host/base/parameter_check.h"

namespace offing::present {
namespace {

using Part = Timeline::Part;

// The ends of a scene's time span, as the parameter table has them.
constexpr double latest_s = 1e6;

float strip_height() {
  return 2.4f * ImGui::GetFontSize();
}

/// Buttons that play, step and jump, the time and its speed, in one line.
void draw_controls(const scene::TimeSection& time, SceneClock& clock, Timeline& timeline) {
  const float em = ImGui::GetFontSize();
  const double frame_s = 1.0 / time.frames_per_second;
  if (ImGui::Button(clock.is_paused() ? "play##clock" : "pause##clock", ImVec2(3.6f * em, 0.0f)))
    clock.toggle_pause();
  explain_item("Space");
  ImGui::SameLine();
  if (ImGui::Button("|<##first frame")) clock.set_time(time.start_s);
  explain_item("first frame of the scene (Home)");
  ImGui::SameLine(0.0f, 1.0f);
  if (ImGui::ArrowButton("step back", ImGuiDir_Left)) clock.step(-frame_s);
  explain_item("one frame back (Left)");
  ImGui::SameLine(0.0f, 1.0f);
  if (ImGui::ArrowButton("step forward", ImGuiDir_Right)) clock.step(frame_s);
  explain_item("one frame forward (Right)");
  ImGui::SameLine(0.0f, 1.0f);
  if (ImGui::Button(">|##last frame")) clock.set_time(last_frame_s(time));
  explain_item("last frame of the scene (End)");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(6.0f * em);
  double time_s = clock.time_s();
  if (ImGui::InputDouble("##time", &time_s, 0.0, 0.0, "%.3f s", ImGuiInputTextFlags_EnterReturnsTrue))
    clock.set_time(std::clamp(time_s, -largest_time_s, largest_time_s));
  explain_item(fmt::format("frame {:.0f}, {:g} a second; click to type a time in s",
                           std::floor(clock.time_s() / frame_s + 1e-6), time.frames_per_second));
  ImGui::SameLine();
  ImGui::Checkbox("loop", &timeline.loops);
  explain_item("repeat the scene's time span (L)");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(5.0f * em);
  auto scale = static_cast<float>(clock.scale());
  if (ImGui::SliderFloat("##time scale", &scale, 1.0f / 64.0f, 64.0f, "%.3g x", ImGuiSliderFlags_Logarithmic))
    clock.set_scale(static_cast<double>(scale));
  explain_item("speed of time ([ and ])");
}

bool draw_record_button(bool is_recording) {
  constexpr const char* label = "record ...";
  stay_in_line(label);
  ImGui::BeginDisabled(is_recording);
  const bool is_wanted = ImGui::Button(label);
  ImGui::EndDisabled();
  explain_item("record pictures or a video of the scene (Ctrl R)");
  return is_wanted;
}

std::string time_left(double seconds) {
  constexpr double minute_s = 60.0, hour_s = 3600.0;
  if (seconds > 2.0 * hour_s) return fmt::format("{:.0f} h", seconds / hour_s);
  if (seconds > 2.0 * minute_s) return fmt::format("{:.0f} min", seconds / minute_s);
  return fmt::format("{:.0f} s", seconds);
}

/// How far a recording is, and whether it is to end.
bool draw_recording(const RecordingProgress& progress) {
  constexpr const char* label = "cancel##recording";
  std::string text = "preparing the recording";
  if (progress.has_begun) text = fmt::format("recorded {} of {} frames", progress.written, progress.count);
  if (progress.written > 0) text += fmt::format(", {} left", time_left(progress.left_s));
  const float button = ImGui::CalcTextSize(label, nullptr, true).x + 2.0f * ImGui::GetStyle().FramePadding.x;
  const float width = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
  // So that the text can be read on it.
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_ButtonHovered));
  ImGui::ProgressBar(static_cast<float>(progress.written) / static_cast<float>(progress.count),
                     ImVec2(std::max(1.0f, width), 0.0f), text.c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine();
  return ImGui::Button(label);
}

/// What the mouse would take hold of.
struct Below {
  Part part = Part::time;
  double key_s = 0.0;  ///< of keyframes
};

/// An end of the span in the bar at the top, keyframes at the bottom, else the time.
Below what_is_below(const scene::Scene& scene, const TimeScale& scale, const ImVec2& low,
                    const ImVec2& high) {
  const float em = ImGui::GetFontSize();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto distance = [&](double time_s) { return std::abs(mouse.x - scale.x_px(time_s)); };
  float nearest = 0.5f * em;
  Below below;
  const auto note = [&](Part part, double time_s) {
    if (distance(time_s) > nearest) return;
    nearest = distance(time_s);
    below = {part, time_s};
  };
  if (mouse.y < low.y + 0.7f * em) {
    note(Part::range_start, scene.time.start_s);
    note(Part::range_end, scene.time.end_s);
  } else if (mouse.y > high.y - 0.8f * em) {
    for (const double time_s : key_times(scene.tracks)) note(Part::keys, time_s);
  }
  return below;
}

void draw_marks(ImDrawList& list, const TimeScale& scale, const ImVec2& low, const ImVec2& high) {
  const float em = ImGui::GetFontSize();
  const double step_s = mark_step_s(scale, 4.0f * em);
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  for (double i = std::ceil(scale.span.first_s / step_s); i * step_s <= scale.span.end_s; ++i) {
    const float x = scale.x_px(i * step_s);
    list.AddLine(ImVec2(x, low.y + 0.5f * em), ImVec2(x, high.y),
                 ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.4f));
    const std::string text = fmt::format("{:g}", i * step_s);
    if (x + ImGui::CalcTextSize(text.c_str()).x < high.x)
      list.AddText(ImVec2(x + 0.2f * em, low.y + 0.5f * em), colour, text.c_str());
  }
}

void draw_span(ImDrawList& list, const scene::TimeSection& time, const Timeline& timeline,
               const ImVec2& low) {
  const float em = ImGui::GetFontSize();
  const float start = timeline.scale.x_px(time.start_s), end = timeline.scale.x_px(time.end_s);
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_SliderGrab, timeline.loops ? 1.0f : 0.5f);
  list.AddRectFilled(ImVec2(start, low.y), ImVec2(end, low.y + 0.3f * em), colour);
  const ImU32 ends = ImGui::GetColorU32(ImGuiCol_SliderGrabActive);
  list.AddTriangleFilled(ImVec2(start, low.y), ImVec2(start + 0.6f * em, low.y),
                         ImVec2(start, low.y + 0.7f * em), ends);
  list.AddTriangleFilled(ImVec2(end - 0.6f * em, low.y), ImVec2(end, low.y), ImVec2(end, low.y + 0.7f * em),
                         ends);
}

void draw_playhead(ImDrawList& list, float x, const ImVec2& low, const ImVec2& high) {
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_PlotLinesHovered);
  list.AddLine(ImVec2(x, low.y), ImVec2(x, high.y), colour, 2.0f);
}

/// A diamond a time. `marked_s`: of keyframes below the mouse.
void draw_keys(ImDrawList& list, const Tracks& tracks, const TimeScale& scale, std::optional<double> marked_s,
               const ImVec2& high) {
  const float em = ImGui::GetFontSize(), half = 0.32f * em, y = high.y - 0.42f * em;
  for (const double time_s : key_times(tracks)) {
    const float x = scale.x_px(time_s);
    const ImVec2 left(x - half, y), top(x, y - half), right(x + half, y), bottom(x, y + half);
    const bool is_marked = marked_s == time_s;
    list.AddQuadFilled(
        left, top, right, bottom,
        ImGui::GetColorU32(is_marked ? ImGuiCol_PlotHistogramHovered : ImGuiCol_PlotHistogram));
    list.AddQuad(left, top, right, bottom, ImGui::GetColorU32(ImGuiCol_WindowBg));
  }
}

void begin_drag(const scene::Scene& scene, SceneClock& clock, Timeline& timeline, const Below& below) {
  timeline.held = below.part;
  timeline.is_moved = false;
  timeline.held_s = below.key_s;
  if (below.part == Part::keys) timeline.before = scene.tracks;
  timeline.plays_on = below.part == Part::time && !clock.is_paused();
  if (timeline.plays_on) clock.toggle_pause();
}

/// Both ends stay a frame apart.
void drag_span(scene::TimeSection& time, Part end, double wanted_s) {
  const double frame_s = 1.0 / time.frames_per_second;
  if (end == Part::range_start) {
    time.start_s = std::clamp(wanted_s, 0.0, std::max(0.0, time.end_s - frame_s));
  } else {
    time.end_s = std::clamp(wanted_s, time.start_s + frame_s, latest_s);
  }
}

/// Takes what the mouse holds there, but for the time; whether that has changed the scene.
bool drag_to(scene::Scene& scene, const Timeline& timeline, double wanted_s) {
  if (timeline.held != Part::keys) {
    const scene::TimeSection last = scene.time;
    drag_span(scene.time, timeline.held, wanted_s);
    return scene.time != last;
  }
  Tracks moved =
      with_moved_keys(timeline.before, timeline.held_s, wanted_s, 1.0 / scene.time.frames_per_second);
  if (moved == scene.tracks) return false;
  scene.tracks = std::move(moved);
  return true;
}

/// What the mouse does along the strip, which is the last item.
Edit follow_mouse(scene::Scene& scene, SceneClock& clock, Timeline& timeline, const Below& below) {
  if (ImGui::IsItemActivated()) begin_drag(scene, clock, timeline, below);
  const Part held = timeline.held;
  if (held == Part::nothing) return Edit::none;
  const double wanted_s =
      nearest_frame_s(timeline.scale.time_s(ImGui::GetIO().MousePos.x), scene.time.frames_per_second);
  if (ImGui::IsItemActive() && held == Part::time) {
    clock.set_time(wanted_s);
    return Edit::none;
  }
  if (ImGui::IsItemActive()) {
    // A click without a move leaves keyframes between two frames where they are.
    const bool has_begun = timeline.is_moved || ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    if (!has_begun || !drag_to(scene, timeline, wanted_s)) return Edit::none;
    timeline.is_moved = true;
    return Edit::going_on;
  }
  timeline.let_go();
  if (std::exchange(timeline.plays_on, false) && clock.is_paused()) clock.toggle_pause();
  return std::exchange(timeline.is_moved, false) ? Edit::done : Edit::none;
}

void draw_tooltip_of(const scene::Scene& scene, Part part, double key_s) {
  switch (part) {
    case Part::range_start:
      return ImGui::SetTooltip("start of the scene: %.3f s", scene.time.start_s);
    case Part::range_end:
      return ImGui::SetTooltip("end of the scene: %.3f s", scene.time.end_s);
    case Part::keys:
      return ImGui::SetTooltip("%.3f s: %s", key_s, values_with_keys(scene.tracks, key_s).c_str());
    default:
      return;
  }
}

/// The time nearest to the mouse at which there are keyframes.
double key_at_mouse(const scene::Scene& scene, const TimeScale& scale) {
  const std::vector<double> times = key_times(scene.tracks);
  return *std::ranges::min_element(
      times, {}, [&](double time_s) { return std::abs(ImGui::GetIO().MousePos.x - scale.x_px(time_s)); });
}

Edit draw_strip(scene::Scene& scene, SceneClock& clock, Timeline& timeline) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size(std::max(1.0f, ImGui::GetContentRegionAvail().x), strip_height());
  const ImVec2 high(low.x + size.x, low.y + size.y);
  // Times stay where they are while the mouse holds one.
  if (timeline.held == Part::nothing) timeline.scale.span = shown_span(scene, clock.time_s());
  const float margin = 0.5f * ImGui::GetFontSize();
  timeline.scale.left_px = low.x + margin;
  timeline.scale.width_px = std::max(1.0f, size.x - 2.0f * margin);
  ImGui::InvisibleButton("strip", size);
  const Below below = what_is_below(scene, timeline.scale, low, high);
  const Edit edit = follow_mouse(scene, clock, timeline, below);
  Part part = timeline.held;
  if (part == Part::nothing && ImGui::IsItemHovered()) part = below.part;
  std::optional<double> key_s;
  if (part == Part::keys) key_s = key_at_mouse(scene, timeline.scale);
  if (part == Part::range_start || part == Part::range_end || part == Part::keys)
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  draw_tooltip_of(scene, part, key_s.value_or(0.0));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, high, true);
  list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg));
  draw_marks(list, timeline.scale, low, high);
  draw_span(list, scene.time, timeline, low);
  draw_keys(list, scene.tracks, timeline.scale, key_s, high);
  draw_playhead(list, timeline.scale.x_px(clock.time_s()), low, high);
  list.PopClipRect();
  return edit;
}

}  // namespace

void Timeline::let_go() {
  held = Part::nothing;
  before.clear();
}

std::optional<TimeSpan> played_span(const scene::Scene& scene, const Timeline& timeline) {
  return timeline.loops ? loop_span(scene.time) : std::nullopt;
}

TimelineEdits draw_timeline(scene::Scene& scene, SceneClock& clock, Timeline& timeline,
                            const std::optional<RecordingProgress>& recording, PanelLayout& layout) {
  constexpr float wide_em = 56.0f;
  TimelineEdits edits;
  layout.place_timeline();
  ImGui::Begin("Timeline", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  const bool is_wide = ImGui::GetContentRegionAvail().x > wide_em * ImGui::GetFontSize();
  // In one line with the strip, which is higher.
  const float top = ImGui::GetCursorPosY();
  if (is_wide) ImGui::SetCursorPosY(top + 0.5f * (strip_height() - ImGui::GetFrameHeight()));
  draw_controls(scene.time, clock, timeline);
  edits.wants_recording = draw_record_button(recording.has_value());
  if (is_wide) {
    ImGui::SameLine();
    ImGui::SetCursorPosY(top);
  }
  edits.scene = draw_strip(scene, clock, timeline);
  if (recording) edits.cancels_recording = draw_recording(*recording);
  layout.end_timeline();
  ImGui::End();
  return edits;
}

}  // namespace offing::present
