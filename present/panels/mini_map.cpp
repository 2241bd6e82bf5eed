#include "present/panels/mini_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <imgui.h>

#include "host/terrain/tiles/tile_posts.h"
#include "present/panels/imgui_versions.h"

namespace offing::present {
namespace {

constexpr int longest_side_px = 256;
// Low ground is green, high ground white, as on maps for walkers.
constexpr std::array<glm::dvec3, 4> tints{
    {{0.45, 0.60, 0.40}, {0.80, 0.78, 0.55}, {0.65, 0.52, 0.42}, {0.97, 0.97, 0.98}}};
// Where maps have their light from.
constexpr double light_elevation = 0.25 * std::numbers::pi;
constexpr glm::dvec3 shallow(0.68, 0.83, 0.93), deep(0.35, 0.55, 0.75);
constexpr ImU32 camera_colour = IM_COL32(213, 94, 0, 255), cone_colour = IM_COL32(213, 94, 0, 70);

glm::dvec3 tint(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (tints.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), tints.size() - 2);
  const double between = place - static_cast<double>(below);
  return tints[below] * (1.0 - between) + tints[below + 1] * between;
}

}  // namespace

std::vector<unsigned char> MiniMap::shaded(const HeightMap& map, std::optional<double> sea_level_m, int width,
                                           int height) {
  const auto [low, high] = std::minmax_element(map.heights_m.begin(), map.heights_m.end());
  const double shore_m = sea_level_m.value_or(-std::numeric_limits<double>::infinity());
  const double lowest_m = std::max(shore_m, static_cast<double>(*low)),
               range_m = std::max(1e-3, static_cast<double>(*high) - lowest_m),
               deepest_m = std::max(1e-3, lowest_m - *low);
  const double step_x = (map.columns - 1.0) / width, step_z = (map.rows - 1.0) / height;
  const auto height_m = [&](int column, int row) {
    const int x = std::clamp(static_cast<int>((column + 0.5) * step_x), 0, map.columns - 1),
              z = std::clamp(static_cast<int>((row + 0.5) * step_z), 0, map.rows - 1);
    return static_cast<double>(map.heights_m[map.index(x, z)]);
  };
  const glm::dvec3 to_light(-std::cos(light_elevation) * std::numbers::sqrt2 / 2.0, std::sin(light_elevation),
                            -std::cos(light_elevation) * std::numbers::sqrt2 / 2.0);
  std::vector<unsigned char> pixels;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double slope_x = (height_m(column + 1, row) - height_m(column - 1, row)) /
                             (2.0 * step_x * map.spacing_x_m),
                   slope_z = (height_m(column, row + 1) - height_m(column, row - 1)) /
                             (2.0 * step_z * map.spacing_z_m);
      const double light =
          std::max(0.0, glm::dot(glm::normalize(glm::dvec3(-slope_x, 1.0, -slope_z)), to_light));
      const double above_m = height_m(column, row) - lowest_m;
      const bool is_water = height_m(column, row) < shore_m;
      const glm::dvec3 colour = is_water ? glm::mix(shallow, deep, -above_m / deepest_m)
                                         : tint(above_m / range_m) * (0.35 + 0.65 * light / to_light.y);
      for (int channel = 0; channel < 3; ++channel) {
        pixels.push_back(static_cast<unsigned char>(std::lround(255.0 * std::min(1.0, colour[channel]))));
      }
    }
  }
  return pixels;
}

void MiniMap::show(const world::TerrainParameters& terrain, std::optional<double> sea_level_m) {
  origin_m_ = {terrain.origin_x_m, terrain.origin_z_m};
  if (width_px_ > 0 && map_ == terrain.map && tiles_ == terrain.tiles && sea_level_m_ == sea_level_m) return;
  map_ = terrain.map;
  sea_level_m_ = sea_level_m;
  tiles_ = terrain.tiles;
  const terrain::TerrainExtent extent = terrain.extent();
  size_m_ = {extent.width_m, extent.depth_m};
  const double scale = longest_side_px / std::max(size_m_.x, size_m_.y);
  width_px_ = std::max(8, static_cast<int>(std::lround(size_m_.x * scale)));
  height_px_ = std::max(8, static_cast<int>(std::lround(size_m_.y * scale)));
  const std::vector<unsigned char> pixels = shaded(
      map_ ? *map_ : terrain::overview_of(tiles_->map, tiles_->read), sea_level_m, width_px_, height_px_);
  texture_ = GlTexture::make();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width_px_, height_px_, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

std::optional<glm::dvec2> MiniMap::draw(const Camera& camera, PanelLayout& layout) const {
  layout.place_low_right();
  ImGui::Begin("Map", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  // In a low window smaller, so that panels at the right have room above it.
  constexpr float most_share = 0.3f;
  const float scale =
      std::min(1.0f, most_share * ImGui::GetIO().DisplaySize.y / static_cast<float>(height_px_));
  const ImVec2 size(scale * static_cast<float>(width_px_), scale * static_cast<float>(height_px_));
  ImGui::Image(texture_id(texture_.name()), size);
  std::optional<glm::dvec2> clicked;
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::dvec2 share((mouse.x - origin.x + 0.5) / size.x, (mouse.y - origin.y + 0.5) / size.y);
    clicked = origin_m_ + glm::clamp(share, 0.0, 1.0) * size_m_;
  }

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(origin, ImVec2(origin.x + size.x, origin.y + size.y), true);
  const glm::dvec2 place = (glm::dvec2(camera.eye_m.x, camera.eye_m.z) - origin_m_) / size_m_;
  const ImVec2 eye(origin.x + static_cast<float>(place.x) * size.x,
                   origin.y + static_cast<float>(place.y) * size.y);
  const double half_angle = std::atan(half_extent(camera).x);
  const auto along = [&](double yaw_rad) {
    constexpr float reach_px = 60.0f;
    return ImVec2(eye.x + reach_px * static_cast<float>(std::sin(yaw_rad)),
                  eye.y - reach_px * static_cast<float>(std::cos(yaw_rad)));
  };
  list.AddTriangleFilled(eye, along(camera.yaw_rad - half_angle), along(camera.yaw_rad + half_angle),
                         cone_colour);
  list.AddCircleFilled(eye, 3.5f, camera_colour);
  list.PopClipRect();
  layout.end_low_right();
  ImGui::End();
  return clicked;
}

}  // namespace offing::present
