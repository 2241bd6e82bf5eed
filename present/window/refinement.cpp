#include "present/window/refinement.h"

#include <algorithm>

#include "present/output/camera_path.h"

namespace offing::present {
namespace {

bool is_same(const Camera& one, const Camera& other) {
  return one.eye_m == other.eye_m && one.yaw_rad == other.yaw_rad && one.pitch_rad == other.pitch_rad &&
         one.roll_rad == other.roll_rad &&
         one.vertical_field_of_view_rad == other.vertical_field_of_view_rad &&
         one.width_px == other.width_px && one.height_px == other.height_px;
}

}  // namespace

bool ShownView::operator==(const ShownView& other) const {
  return time_s == other.time_s && is_same(camera, other.camera) && scene_revision == other.scene_revision &&
         debug == other.debug && fill == other.fill && terrain == other.terrain && meshes == other.meshes &&
         ray_share == other.ray_share;
}

bool moves_by_itself(const scene::Scene& scene) {
  const scene::ViewScene& view = scene.view;
  return scene.has_sea() || scene.has_clouds() || (view.sun_time_utc && view.sun_time_scale != 0.0) ||
         std::ranges::any_of(scene.meshes, [](const auto& mesh) { return mesh.spin_radps != 0.0; }) ||
         std::ranges::any_of(scene.tracks, [](const auto& track) { return !is_of_camera(track.first); });
}

std::optional<Sharpness> Refinement::next(const ShownView& view, double now_s, double input_s) const {
  if (view_ != view) return Sharpness::quick;
  if (drawn_ == Sharpness::still || now_s - std::max(since_s_, input_s) < settled_s) return std::nullopt;
  return drawn_ == Sharpness::quick ? Sharpness::fine : Sharpness::still;
}

void Refinement::note(const ShownView& view, Sharpness drawn, double now_s) {
  if (view_ != view) since_s_ = now_s;
  view_ = view;
  drawn_ = drawn;
}

}  // namespace offing::present
