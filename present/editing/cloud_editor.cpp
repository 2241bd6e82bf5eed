#include "present/editing/cloud_editor.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/clouds/shape/genera.h"
#include "host/scene/prepare/scene_clouds.h"

namespace offing::present {
namespace {

/// The cloud that new balls belong to: that of what is picked.
std::optional<std::size_t> active_cloud(const CloudEditing& editing) {
  return editing.picked.empty() ? std::nullopt : std::optional(editing.picked.back().cloud);
}

/// A click makes a ball or a cloud where its ray meets the height of what is picked, or of the genus.
Edit place(ViewState& state, const ShownClouds& shown, const Ray& ray) {
  CloudEditing& editing = state.clouds;
  double altitude_m = clouds::preset(editing.genus).position_m.y;
  if (!editing.picked.empty()) altitude_m = sphere_of(shown, editing.picked.back()).centre_m.y;
  const std::optional<glm::dvec3> place_m = on_plane(ray, {0.0, altitude_m, 0.0}, glm::dvec3(0.0, 1.0, 0.0));
  if (!place_m) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("cloud: expected a click on the plane at {:.0f} m, found none there", altitude_m),
                "look up at it from below, or down from above");
  }
  const CloudPart part = editing.tool == CloudTool::place_cloud
                             ? add_cloud(state.scene, editing.genus, *place_m)
                             : add_ball(state.scene, active_cloud(editing), editing.genus,
                                        {*place_m, editing.new_radius_m}, shown.time_s);
  editing.pick = part.ball ? CloudPick::balls : CloudPick::clouds;
  editing.forget_picks();
  editing.picked = {part};
  return Edit::done;
}

/// What is picked with another part: beside it, or in its place; one that is picked already goes.
void pick_part(CloudEditing& editing, const std::optional<CloudPart>& part, bool is_beside) {
  if (!is_beside) editing.picked.clear();
  if (!part) return;
  if (std::erase(editing.picked, *part) == 0 || !is_beside) editing.picked.push_back(*part);
}

void pick_at(ViewState& state, const ShownClouds& shown, const Ray& ray, bool is_beside) {
  CloudEditing& editing = state.clouds;
  if (editing.pick == CloudPick::particles) {
    editing.particles = {};
    return;
  }
  if (editing.pick == CloudPick::clouds) {
    pick_part(editing, pick_cloud(shown, ray), is_beside);
    return;
  }
  std::optional<CloudPart> last;
  if (!is_beside && !editing.picked.empty()) last = editing.picked.back();
  pick_part(editing, pick_ball(shown, ray, last), is_beside);
}

void pick_in(ViewState& state, const ShownClouds& shown, const Screen& screen, const ClipBox& box) {
  CloudEditing& editing = state.clouds;
  if (editing.pick == CloudPick::particles) {
    editing.particles = {};
    if (shown.view != nullptr)
      editing.particles = particles_in(state.scene, *shown.view, screen.camera, box, shown.time_s);
    return;
  }
  const PartKind kind = editing.pick == CloudPick::balls ? PartKind::balls : PartKind::clouds;
  for (const CloudPart& part : parts_in(shown, screen, box, kind)) {
    if (std::find(editing.picked.begin(), editing.picked.end(), part) == editing.picked.end())
      editing.picked.push_back(part);
  }
}

}  // namespace

std::optional<Sphere> held_sphere(const ViewState& state, const ShownClouds& shown) {
  const CloudEditing& editing = state.clouds;
  if (editing.pick == CloudPick::particles) {
    if (editing.particles.empty()) return {};
    return Sphere{editing.particles.middle_m(), 0.0};
  }
  if (editing.picked.empty()) return {};
  return sphere_of(shown, editing.picked.back());
}

HandleSet cloud_handles(const ViewState& state) {
  return state.clouds.pick == CloudPick::particles ? place_handles() : sphere_handles();
}

void forget_lost_picks(ViewState& state) {
  CloudEditing& editing = state.clouds;
  std::erase_if(editing.picked, [&](const CloudPart& part) { return !has_part(state.scene, part); });
  const auto is_lost = [&](const PickedParticles::InCloud& in_cloud) {
    return in_cloud.cloud >= state.scene.clouds.size() ||
           (in_cloud.edit && *in_cloud.edit >= state.scene.clouds[in_cloud.cloud].edits.size());
  };
  const auto& in_clouds = editing.particles.clouds;
  if (std::any_of(in_clouds.begin(), in_clouds.end(), is_lost)) editing.particles = {};
}

void CloudEditor::press(ViewState& state, const ShownClouds& shown, const Screen& screen,
                        const PointerEvent& event) {
  const bool is_placing = state.clouds.tool != CloudTool::pick;
  pressed_ = {event.clip, event.is_beside && !is_placing};
  const std::optional<Sphere> sphere = held_sphere(state, shown);
  if (is_placing || !sphere) return;
  const std::optional<ObjectHandle> handle = object_handle_at(
      object_handle_places(screen, *sphere, cloud_handles(state)), pixel_of_clip(screen, event.clip));
  if (!handle) return;
  pressed_.reset();
  grab_ = Grab{*handle, *sphere, event.clip, state.scene, state.clouds.particles, event.clip, false};
}

Edit CloudEditor::pull(ViewState& state, const Screen& screen, glm::dvec2 clip, double step_m) {
  if (clip == grab_->at) return Edit::none;
  const std::optional<ObjectPull> pull =
      object_pull(screen, grab_->handle, grab_->sphere, grab_->from, clip, {.way_m = step_m});
  if (!pull) return Edit::none;
  grab_->at = clip;
  grab_->has_pulled = true;
  scene::copy_clouds(grab_->before, state.scene);
  if (state.clouds.pick == CloudPick::particles) {
    state.clouds.particles = grab_->particles;
    push_particles(state.scene, state.clouds.particles, pull->way_m);
    return Edit::going_on;
  }
  for (const CloudPart& part : state.clouds.picked) {
    if (pull->ratio == 1.0) {
      move_part(state.scene, part, pull->way_m);
    } else {
      resize_part(state.scene, part, pull->ratio);
    }
  }
  return Edit::going_on;
}

Edit CloudEditor::release(ViewState& state, const ShownClouds& shown, const Screen& screen,
                          const PointerEvent& event, double step_m) {
  if (grab_) {
    pull(state, screen, event.clip, step_m);
    const Grab grab = *std::exchange(grab_, std::nullopt);
    if (grab.at != grab.from) return Edit::done;
    // Back where it was: nothing to undo, but what was shown on the way is still there.
    return grab.has_pulled ? Edit::taken_back : Edit::none;
  }
  if (!pressed_) return Edit::none;
  const Press pressed = *std::exchange(pressed_, std::nullopt);
  const double way_px = glm::distance(pixel_of_clip(screen, pressed.clip), pixel_of_clip(screen, event.clip));
  // Drags look around, with a tool too.
  if (state.clouds.tool != CloudTool::pick) {
    return way_px <= click_px ? place(state, shown, ray_at(screen, event.clip)) : Edit::none;
  }
  if (way_px <= click_px) {
    pick_at(state, shown, ray_at(screen, event.clip), pressed.is_beside);
  } else if (pressed.is_beside) {
    pick_in(state, shown, screen, box_between(pressed.clip, event.clip));
  }
  return Edit::none;
}

Edit CloudEditor::turn(ViewState& state, const world::WorldClouds* view, const Screen& screen,
                       std::vector<PointerEvent>& events, const PointerNow& pointer) {
  forget_lost_picks(state);
  const ShownClouds shown{state.scene, view, state.clock.time_s()};
  const double step_m = pointer.is_snapping ? state.clouds.step_m : 0.0;
  Edit edit = Edit::none;
  std::erase_if(events, [&](const PointerEvent& event) {
    const bool held = holds();
    if (event.kind == PointerEvent::Kind::pressed) {
      press(state, shown, screen, event);
    } else {
      edit = std::max(edit, release(state, shown, screen, event, step_m));
    }
    return held || holds();
  });
  if (grab_) edit = std::max(edit, pull(state, screen, pointer.clip, step_m));
  return edit;
}

std::optional<ClipBox> CloudEditor::box(glm::dvec2 pointer) const {
  if (!pressed_ || !is_boxing()) return {};
  return box_between(pressed_->clip, pointer);
}

void CloudEditor::let_go() {
  grab_.reset();
  pressed_.reset();
}

Edit CloudEditor::remove(ViewState& state) {
  let_go();
  forget_lost_picks(state);
  CloudEditing& editing = state.clouds;
  if (editing.picked.empty() && editing.particles.empty()) {
    throw Error(ErrorKind::bad_usage, "nothing is selected", "click on it, or select it in the list");
  }
  if (!editing.particles.empty()) {
    remove_particles(state.scene, editing.particles);
  } else {
    remove_parts(state.scene, editing.picked);
  }
  editing.forget_picks();
  return Edit::done;
}

Edit CloudEditor::duplicate(ViewState& state, const world::WorldClouds* view) {
  let_go();
  forget_lost_picks(state);
  CloudEditing& editing = state.clouds;
  if (editing.picked.empty()) {
    throw Error(ErrorKind::bad_usage, "nothing is selected that can be copied",
                "click on a mesh, a cloud or a light, or select it in the list");
  }
  const ShownClouds shown{state.scene, view, state.clock.time_s()};
  const Sphere sphere = sphere_of(shown, editing.picked.back());
  editing.picked = duplicate_parts(state.scene, editing.picked, {sphere.radius_m, 0.0, 0.0});
  return Edit::done;
}

}  // namespace offing::present
