#include "present/editing/ray_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "host/terrain/cast/step_colours.h"

namespace offing::present {
namespace {

constexpr ImU32 cell_colour = IM_COL32(255, 255, 255, 255);
// Levels 1, 2, ... in turn (Okabe & Ito 2008).
constexpr std::array<ImU32, 5> level_colours{IM_COL32(240, 228, 66, 255), IM_COL32(230, 159, 0, 255),
                                             IM_COL32(213, 94, 0, 255), IM_COL32(204, 121, 167, 255),
                                             IM_COL32(86, 180, 233, 255)};
constexpr ImU32 ray_colour = IM_COL32(0, 158, 115, 255);
constexpr double near_m = 0.1;

/// Lines of the world on the screen.
class Pen {
 public:
  explicit Pen(const Camera& camera)
      : camera_(camera),
        axes_(basis(camera)),
        extent_(half_extent(camera)),
        screen_(ImGui::GetIO().DisplaySize),
        list_(*ImGui::GetBackgroundDrawList()) {}

  void line(const glm::dvec3& from_m, const glm::dvec3& to_m, ImU32 colour, float width_px) {
    glm::dvec3 from = seen(from_m), to = seen(to_m);
    if (from.z < near_m && to.z < near_m) return;
    if (from.z < near_m) from = cut(to, from);
    if (to.z < near_m) to = cut(from, to);
    list_.AddLine(on_screen(from), on_screen(to), colour, width_px);
  }

 private:
  /// Right, up and forward of the eye.
  glm::dvec3 seen(const glm::dvec3& place_m) const {
    const glm::dvec3 from_eye = place_m - camera_.eye_m;
    return {glm::dot(from_eye, axes_.right), glm::dot(from_eye, axes_.up), glm::dot(from_eye, axes_.forward)};
  }
  static glm::dvec3 cut(const glm::dvec3& before, const glm::dvec3& behind) {
    return before + (behind - before) * ((before.z - near_m) / (before.z - behind.z));
  }
  ImVec2 on_screen(const glm::dvec3& point) const {
    const double x = point.x / (point.z * extent_.x), y = point.y / (point.z * extent_.y);
    return {static_cast<float>(0.5 + 0.5 * x) * screen_.x, static_cast<float>(0.5 - 0.5 * y) * screen_.y};
  }

  Camera camera_;
  CameraBasis axes_;
  glm::dvec2 extent_;
  ImVec2 screen_;
  ImDrawList& list_;
};

/// A corner of a node: on its maximum or, of a cell, on the ground.
glm::dvec3 corner_m(const terrain::RayNode& node, const world::WorldTerrain& terrain, int right, int down) {
  const HeightMap& map = *terrain.parameters().map;
  const int column = std::min(node.first_x + right * node.side_cells, map.columns - 1),
            row = std::min(node.first_z + down * node.side_cells, map.rows - 1);
  const double height_m =
      node.level == 0 ? static_cast<double>(map.heights_m[map.index(column, row)]) : node.maximum_m;
  return {terrain.parameters().origin_x_m + column * map.spacing_x_m, height_m,
          terrain.parameters().origin_z_m + row * map.spacing_z_m};
}

ImU32 colour_of(int level) {
  if (level == 0) return cell_colour;
  return level_colours[static_cast<std::size_t>(level - 1) % level_colours.size()];
}

ImVec4 screen_colour(float steps) {
  const std::array<float, 3> linear = terrain::step_colour(steps);
  const auto srgb = [](float value) {
    return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
  };
  return {srgb(linear[0]), srgb(linear[1]), srgb(linear[2]), 1.0f};
}

}  // namespace

void draw_ray_overlay(const TerrainPick& pick, const world::WorldTerrain& terrain, const Camera& camera) {
  Pen pen(camera);
  for (const terrain::RayNode& node : pick.nodes) {
    const ImU32 colour = colour_of(node.level);
    const float width_px = node.is_passed_over ? 1.0f : 2.0f;
    const std::array<glm::dvec3, 4> corners{corner_m(node, terrain, 0, 0), corner_m(node, terrain, 1, 0),
                                            corner_m(node, terrain, 1, 1), corner_m(node, terrain, 0, 1)};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      pen.line(corners[i], corners[(i + 1) % corners.size()], colour, width_px);
    }
  }
  pen.line(pick.ray.origin_m, pick.place_m, ray_colour, 2.0f);
}

void draw_step_legend(PanelLayout& layout) {
  constexpr int pieces = 80;
  const float bar_height = ImGui::GetFontSize();
  layout.place_low_left();
  ImGui::Begin("Steps of a ray", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = 11.0f * ImGui::GetFontSize(), most = terrain::step_colours.back().steps;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < pieces; ++i) {
    const float left = origin.x + width * static_cast<float>(i) / pieces,
                right = origin.x + width * static_cast<float>(i + 1) / pieces;
    const ImVec4 colour = screen_colour(most * (static_cast<float>(i) + 0.5f) / pieces);
    list.AddRectFilled(ImVec2(left, origin.y), ImVec2(right, origin.y + bar_height),
                       ImGui::ColorConvertFloat4ToU32(colour));
  }
  for (const terrain::StepColour& mark : terrain::step_colours) {
    const bool is_last = mark.steps == most;
    const std::string text = fmt::format(fmt::runtime(is_last ? "{:.0f}+" : "{:.0f}"), mark.steps);
    const float x = origin.x + width * mark.steps / most;
    list.AddText(ImVec2(x - (is_last ? ImGui::CalcTextSize(text.c_str()).x : 0.0f), origin.y + bar_height),
                 ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  }
  ImGui::Dummy(ImVec2(width, bar_height + ImGui::GetFontSize()));
  layout.end_low_left();
  ImGui::End();
}

}  // namespace offing::present
