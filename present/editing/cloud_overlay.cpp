#include "present/editing/cloud_overlay.h"

#include <algorithm>
#include <vector>

#include "present/editing/cloud_editor.h"
#include "present/editing/objects/handle_overlay.h"

namespace offing::present {
namespace {

constexpr int outline_points = 48;
// Of more balls than these, outlines would hide the clouds: only those of clouds with a pick are drawn.
constexpr std::size_t most_outlines = 200;

constexpr ImU32 ball_colour = IM_COL32(255, 255, 255, 150), outline_shade_colour = IM_COL32(0, 0, 0, 60),
                particle_colour = IM_COL32(255, 120, 40, 255);

class Overlay {
 public:
  Overlay(const ViewState& state, const world::WorldClouds* view, const Screen& screen)
      : state_(state), shown_{state.scene, view, state.clock.time_s()}, screen_(screen), painter_(screen) {}

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
      const bool is_picked = std::find(picked.begin(), picked.end(), part) != picked.end();
      if (!is_picked && !is_hidden(state_.scene, part.cloud)) outline(sphere, ball_colour, 1.0);
    }
  }

  void draw_picks() const {
    for (const CloudPart& part : state_.clouds.picked) {
      if (has_part(state_.scene, part)) outline(sphere_of(shown_, part), selected_colour, 2.0);
    }
    const PickedParticles& particles = state_.clouds.particles;
    for (const glm::dvec3& place_m : particles.places_m) {
      if (const auto px = pixel_of(screen_, place_m + particles.push_m))
        painter_.disc(*px, 2.0, particle_colour);
    }
    const bool is_lost = std::any_of(state_.clouds.picked.begin(), state_.clouds.picked.end(),
                                     [&](const CloudPart& part) { return !has_part(state_.scene, part); });
    if (is_lost) return;
    const std::optional<Sphere> sphere = held_sphere(state_, shown_);
    if (!sphere) return;
    draw_object_handles(painter_, screen_, *sphere, cloud_handles(state_));
    explain_object_handle(painter_, screen_, *sphere, cloud_handles(state_));
  }

  void draw_box(const ClipBox& box) const {
    const glm::dvec2 a = pixel_of_clip(screen_, box.low), b = pixel_of_clip(screen_, box.high);
    painter_.frame({a.x, b.y}, {b.x, a.y}, selected_colour);
  }

 private:
  void outline(const Sphere& sphere, ImU32 colour, double width_px) const {
    std::vector<glm::dvec2> points;
    for (const glm::dvec3& place_m : outline_of(sphere, screen_.camera.eye_m, outline_points)) {
      const std::optional<glm::dvec2> px = pixel_of(screen_, place_m);
      if (!px) return;
      points.push_back(*px);
    }
    // White alone is lost on a white cloud.
    painter_.outline(points, outline_shade_colour, width_px + 1.5);
    painter_.outline(points, colour, width_px);
  }

  const ViewState& state_;
  ShownClouds shown_;
  Screen screen_;
  OverlayPainter painter_;
};

}  // namespace

void draw_cloud_overlay(const ViewState& state, const world::WorldClouds* view, const Screen& screen,
                        const std::optional<ClipBox>& box) {
  const Overlay overlay(state, view, screen);
  if (state.clouds.pick == CloudPick::balls) overlay.draw_balls();
  if (state.clouds.pick != CloudPick::none) overlay.draw_picks();
  if (box) overlay.draw_box(*box);
}

}  // namespace offing::present
