#include "present/editing/cloud_overlay.h"

#include <algorithm>
#include <array>
#include <vector>

#include <imgui.h>

#include "present/editing/cloud_editor.h"

namespace offing::present {
namespace {

constexpr int outline_points = 48;
// Of more balls than these, outlines would hide the clouds: only those of clouds with a pick are drawn.
constexpr std::size_t most_outlines = 200;

constexpr ImU32 ball_colour = IM_COL32(255, 255, 255, 150), picked_colour = IM_COL32(255, 200, 40, 255),
                shade_colour = IM_COL32(0, 0, 0, 160), outline_shade_colour = IM_COL32(0, 0, 0, 60),
                size_colour = IM_COL32(120, 230, 120, 255), particle_colour = IM_COL32(255, 120, 40, 255);
constexpr std::array<ImU32, 3> axis_colours{IM_COL32(240, 80, 80, 255), IM_COL32(110, 220, 90, 255),
                                            IM_COL32(90, 140, 255, 255)};

ImVec2 point(glm::dvec2 place_px) {
  return {static_cast<float>(place_px.x), static_cast<float>(place_px.y)};
}

class Overlay {
 public:
  Overlay(const ViewState& state, const world::WorldClouds* view)
      : state_(state),
        shown_{state.scene, view, state.clock.time_s()},
        screen_{state.camera.camera(), {ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y}},
        list_(*ImGui::GetBackgroundDrawList()) {}

  void draw_balls() const {
    const std::vector<CloudPart>& picked = state_.clouds.picked;
    std::vector<std::pair<CloudPart, Sphere>> balls, active;
    for (std::size_t cloud = 0; cloud < state_.scene.clouds.size(); ++cloud) {
      const std::vector<Sphere> spheres = balls_of(state_.scene, cloud, shown_.time_s);
      const bool is_active = std::any_of(picked.begin(), picked.end(),
                                         [&](const CloudPart& part) { return part.cloud == cloud; });
      for (std::size_t ball = 0; ball < spheres.size(); ++ball) {
        balls.emplace_back(CloudPart{cloud, ball}, spheres[ball]);
        if (is_active) active.push_back(balls.back());
      }
    }
    for (const auto& [part, sphere] : balls.size() > most_outlines ? active : balls) {
      if (std::find(picked.begin(), picked.end(), part) == picked.end()) outline(sphere, ball_colour, 1.0f);
    }
  }

  void draw_picks() const {
    for (const CloudPart& part : state_.clouds.picked) {
      if (has_part(state_.scene, part)) outline(sphere_of(shown_, part), picked_colour, 2.0f);
    }
    const PickedParticles& particles = state_.clouds.particles;
    for (const glm::dvec3& place_m : particles.places_m) {
      if (const auto px = pixel_of(screen_, place_m + particles.push_m))
        list_.AddCircleFilled(point(*px), 2.0f, particle_colour, 6);
    }
    const bool is_lost = std::any_of(state_.clouds.picked.begin(), state_.clouds.picked.end(),
                                     [&](const CloudPart& part) { return !has_part(state_.scene, part); });
    if (is_lost) return;
    if (const std::optional<Sphere> sphere = held_sphere(state_, shown_)) draw_handles(*sphere);
  }

  void draw_box(const ClipBox& box) const {
    const ImVec2 a = point(pixel_of_clip(screen_, box.low)), b = point(pixel_of_clip(screen_, box.high));
    list_.AddRect({a.x, b.y}, {b.x, a.y}, picked_colour);
  }

 private:
  void outline(const Sphere& sphere, ImU32 colour, float width_px) const {
    std::vector<ImVec2> points;
    for (const glm::dvec3& place_m : outline_of(sphere, screen_.camera.eye_m, outline_points)) {
      const std::optional<glm::dvec2> px = pixel_of(screen_, place_m);
      if (!px) return;
      points.push_back(point(*px));
    }
    // White alone is lost on a white cloud.
    const int count = static_cast<int>(points.size());
    list_.AddPolyline(points.data(), count, outline_shade_colour, ImDrawFlags_Closed, width_px + 1.5f);
    list_.AddPolyline(points.data(), count, colour, ImDrawFlags_Closed, width_px);
  }

  void draw_handles(const Sphere& sphere) const {
    const std::optional<glm::dvec2> middle_px = pixel_of(screen_, sphere.centre_m);
    if (!middle_px) return;
    const ImVec2 middle = point(*middle_px);
    for (const CloudHandlePlace& place : cloud_handle_places(screen_, sphere)) {
      const ImVec2 at = point(place.place_px);
      const ImVec2 low(at.x - 5.0f, at.y - 5.0f), high(at.x + 5.0f, at.y + 5.0f);
      const auto number = static_cast<std::size_t>(place.handle);
      if (place.handle <= CloudHandle::z) {
        list_.AddLine(middle, at, axis_colours[number], 2.0f);
        list_.AddCircleFilled(at, 6.0f, axis_colours[number]);
        list_.AddCircle(at, 6.0f, shade_colour);
      } else if (place.handle <= CloudHandle::plane_z) {
        list_.AddRectFilled(low, high, axis_colours[number - static_cast<std::size_t>(CloudHandle::plane_x)]);
        list_.AddRect(low, high, shade_colour);
      } else if (place.handle == CloudHandle::radius) {
        list_.AddRectFilled(low, high, size_colour);
        list_.AddRect(low, high, shade_colour);
      } else {
        list_.AddCircleFilled(at, 6.0f, picked_colour);
        list_.AddCircle(at, 6.0f, shade_colour);
      }
    }
  }

  const ViewState& state_;
  ShownClouds shown_;
  Screen screen_;
  ImDrawList& list_;
};

}  // namespace

void draw_cloud_overlay(const ViewState& state, const world::WorldClouds* view,
                        const std::optional<ClipBox>& box) {
  const Overlay overlay(state, view);
  if (state.clouds.pick == CloudPick::balls) overlay.draw_balls();
  if (state.clouds.pick != CloudPick::none) overlay.draw_picks();
  if (box) overlay.draw_box(*box);
}

}  // namespace offing::present
