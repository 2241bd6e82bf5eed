#include "present/panels/sun_dial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <imgui.h>

#include "present/panels/panel_layout.h"

namespace offing::present {
namespace {

constexpr double right_angle_rad = 0.5 * std::numbers::pi;
constexpr int seconds_of_day = 86'400;
// The day of a sun that had none: the longest one of the north.
constexpr UtcTime usual_day{.year = 2020, .month = 6, .day = 21, .hour = 12, .minute = 0, .second = 0};

constexpr ImU32 sky_colour = IM_COL32(60, 110, 170, 255), night_colour = IM_COL32(25, 30, 60, 255),
                line_colour = IM_COL32(255, 255, 255, 90), sun_colour = IM_COL32(255, 220, 90, 255);

ImVec2 at(ImVec2 middle, float radius, glm::dvec2 place) {
  return {middle.x + radius * static_cast<float>(place.x), middle.y + radius * static_cast<float>(place.y)};
}

void draw_map(ImVec2 middle, float radius, const sky::SunAngles& now) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(middle, radius * static_cast<float>(dial_reach), night_colour);
  list.AddCircleFilled(middle, radius, sky_colour);
  for (const float share : {1.0f / 3.0f, 2.0f / 3.0f}) list.AddCircle(middle, share * radius, line_colour);
  list.AddLine(at(middle, radius, {0.0, -1.0}), at(middle, radius, {0.0, 1.0}), line_colour);
  list.AddLine(at(middle, radius, {-1.0, 0.0}), at(middle, radius, {1.0, 0.0}), line_colour);
  list.AddText({middle.x + 2.0f, middle.y - radius}, line_colour, "N");
  glm::dvec2 place = place_on_dial(now);
  if (const double length = glm::length(place); length > dial_reach) place *= dial_reach / length;
  const float sun_radius = 0.1f * radius;
  list.AddCircleFilled(at(middle, radius, place), sun_radius, sun_colour);
  list.AddCircle(at(middle, radius, place), sun_radius, IM_COL32(0, 0, 0, 200));
}

void end_keyframes(scene::Scene& scene) {
  scene.tracks.erase("sun.azimuth_deg");
  scene.tracks.erase("sun.elevation_deg");
}

Edit draw_hour(scene::Scene& scene) {
  const bool is_dated = scene.view.sun_time_utc.has_value();
  const UtcTime time = scene.view.sun_time_utc.value_or(usual_day);
  float hour = static_cast<float>(time.hour) + static_cast<float>(time.minute) / 60.0f +
               static_cast<float>(time.second) / 3600.0f;
  const bool is_moved = ImGui::SliderFloat("hour of the day", &hour, 0.0f, 24.0f,
                                           is_dated ? "%.2f h UTC" : "any", ImGuiSliderFlags_AlwaysClamp);
  if (is_moved) set_hour(scene, static_cast<double>(hour));
  if (ImGui::IsItemDeactivatedAfterEdit()) return Edit::done;
  return is_moved ? Edit::going_on : Edit::none;
}

}  // namespace

glm::dvec2 place_on_dial(const sky::SunAngles& sun) {
  const double distance = 1.0 - sun.elevation_rad / right_angle_rad;
  return distance * glm::dvec2(std::sin(sun.azimuth_rad), -std::cos(sun.azimuth_rad));
}

sky::SunAngles sun_of_dial(glm::dvec2 place) {
  const double distance = std::min(glm::length(place), dial_reach);
  double azimuth_rad = std::atan2(place.x, -place.y);
  if (azimuth_rad < 0.0) azimuth_rad += 2.0 * std::numbers::pi;
  return {azimuth_rad, (1.0 - distance) * right_angle_rad};
}

void place_sun(scene::Scene& scene, const sky::SunAngles& sun) {
  end_keyframes(scene);
  scene.view.sun_direction = sun;
  scene.view.sun_time_utc.reset();
}

void set_hour(scene::Scene& scene, double hour) {
  end_keyframes(scene);
  UtcTime midnight = scene.view.sun_time_utc.value_or(usual_day);
  midnight.hour = midnight.minute = midnight.second = 0;
  const int second = std::clamp(static_cast<int>(std::lround(3600.0 * hour)), 0, seconds_of_day - 1);
  scene.view.sun_time_utc = from_unix_seconds(unix_seconds(midnight) + second);
}

Edit draw_sun_presets(scene::Scene& scene) {
  struct Hour {
    const char* label;
    double azimuth_deg, elevation_deg;
  };
  // Solar hours 4, 8, 12, 16, 19 and 20 at 45 degrees north, with the sun's declination of June 21, 23.44
  // degrees: sin h = sin p sin d + cos p cos d cos H.
  static constexpr std::array<Hour, 6> hours{{{"dawn", 52.7, -2.5},
                                              {"morning", 93.1, 37.3},
                                              {"noon", 180.0, 68.4},
                                              {"afternoon", 266.9, 37.3},
                                              {"evening", 296.9, 6.5},
                                              {"dusk", 307.3, -2.5}}};
  Edit edit = Edit::none;
  for (const Hour& hour : hours) {
    if (&hour != hours.data()) stay_in_line(hour.label);
    if (!ImGui::SmallButton(hour.label)) continue;
    constexpr double degree_rad = std::numbers::pi / 180.0;
    place_sun(scene, {hour.azimuth_deg * degree_rad, hour.elevation_deg * degree_rad});
    edit = Edit::done;
  }
  return edit;
}

Edit draw_sun_dial(scene::Scene& scene, const sky::SunAngles& now) {
  const float radius = 4.0f * ImGui::GetFontSize(), side = 2.0f * radius * static_cast<float>(dial_reach);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 middle(corner.x + 0.5f * side, corner.y + 0.5f * side);
  ImGui::InvisibleButton("sun dial", {side, side});
  Edit edit = Edit::none;
  if (ImGui::IsItemActive()) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const sky::SunAngles wanted =
        sun_of_dial(glm::dvec2(mouse.x - middle.x, mouse.y - middle.y) / static_cast<double>(radius));
    if (place_on_dial(wanted) != place_on_dial(now)) {
      place_sun(scene, wanted);
      edit = Edit::going_on;
    }
  }
  // A click alone has moved the sun too.
  if (ImGui::IsItemDeactivated()) edit = Edit::done;
  draw_map(middle, radius, now);
  ImGui::SameLine();
  ImGui::Text("sun at\n%.0f deg,\n%.1f deg\nhigh", now.azimuth_rad * 180.0 / std::numbers::pi,
              now.elevation_rad * 180.0 / std::numbers::pi);
  return std::max(edit, draw_hour(scene));
}

}  // namespace offing::present
