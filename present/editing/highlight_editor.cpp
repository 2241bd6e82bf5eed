#include "present/editing/highlight_editor.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "present/editing/highlight_edits.h"
#include "present/editing/objects/handle_overlay.h"

namespace offing::present {
namespace {

using highlights::DrawnHighlight;

// A push goes no further than this a frame: where the surface bends the next ones fix the way.
constexpr double most_half_widths = 1.0;

constexpr ImU32 line_colour = IM_COL32(255, 255, 255, 220), turn_colour = IM_COL32(90, 200, 255, 255),
                size_colour = IM_COL32(120, 230, 120, 255);

highlights::Projector box_in_world(const std::vector<world::WorldMesh>& meshes, const HighlightName& name,
                                   const DrawnHighlight& highlight) {
  return in_world(highlight.whole, meshes[name.mesh].motion());
}

void draw_handle(const OverlayPainter& painter, const HandlePlace& place) {
  if (place.handle == Handle::move) {
    painter.knob(place.place_px, selected_colour);
  } else if (place.handle == Handle::rotate) {
    painter.knob(place.place_px, turn_colour);
  } else {
    painter.square_knob(place.place_px, size_colour);
  }
}

}  // namespace

void HighlightEditor::press(ViewState& state, const std::vector<world::WorldMesh>& meshes,
                            const Screen& screen, glm::dvec2 clip) {
  const DrawnHighlight* highlight = picked_highlight(state.scene, meshes, state.picked);
  if (highlight == nullptr) return;
  const highlights::Projector box = box_in_world(meshes, *state.picked, *highlight);
  const std::optional<Handle> handle = handle_at(handle_places(screen, box), pixel_of_clip(screen, clip));
  if (!handle) return;
  const std::optional<glm::dvec2> from_m = place_on_plane(screen, box, clip);
  if (!from_m) return;
  grab_ = Grab{*handle, highlight->controls, highlight->whole, *from_m};
  // Keyframes are set at one time, not all along the way.
  const bool moves = highlight->rule >= 0 &&
                     has_keys(state.scene, {state.picked->mesh, static_cast<std::size_t>(highlight->rule)});
  if (moves && !state.clock.is_paused()) state.clock.toggle_pause();
}

void HighlightEditor::pull(ViewState& state, const std::vector<world::WorldMesh>& meshes,
                           const Screen& screen, glm::dvec2 clip) {
  const DrawnHighlight* highlight = picked_highlight(state.scene, meshes, state.picked);
  if (highlight == nullptr) return;
  const highlights::RigidMotion& motion = meshes[state.picked->mesh].motion();
  highlights::HighlightControls controls = highlight->controls;
  if (grab_->handle == Handle::move) {
    // Toward the mouse from where the highlight has got to: the way there is over the surface.
    const std::optional<glm::dvec2> to_m = place_on_plane(screen, in_world(highlight->whole, motion), clip);
    if (!to_m) return;
    const glm::dvec2 most_m =
        0.5 * most_half_widths * glm::dvec2(std::min(highlight->found.width_m, highlight->found.height_m));
    controls = pushed(controls, highlight->found, glm::clamp(*to_m - grab_->from_m, -most_m, most_m));
  } else {
    const std::optional<glm::dvec2> to_m = place_on_plane(screen, in_world(grab_->box, motion), clip);
    if (!to_m) return;
    controls = pulled(grab_->controls, grab_->handle, grab_->from_m, *to_m);
  }
  store_controls(state.scene, controls_of(state.scene, *state.picked, *highlight), controls,
                 state.clock.time_s());
}

Edit HighlightEditor::turn(ViewState& state, const std::vector<world::WorldMesh>& meshes,
                           const Screen& screen, std::vector<PointerEvent>& events, glm::dvec2 pointer) {
  Edit edit = Edit::none;
  std::erase_if(events, [&](const PointerEvent& event) {
    const bool held = holds();
    if (event.kind == PointerEvent::Kind::pressed) {
      press(state, meshes, screen, event.clip);
    } else if (held) {
      pull(state, meshes, screen, event.clip);
      grab_.reset();
      edit = Edit::done;
    }
    return held || holds();
  });
  if (!grab_) return edit;
  pull(state, meshes, screen, pointer);
  return Edit::going_on;
}

Edit HighlightEditor::set_keys(ViewState& state, const std::vector<world::WorldMesh>& meshes) const {
  const DrawnHighlight* highlight = picked_highlight(state.scene, meshes, state.picked);
  if (highlight == nullptr) {
    state.message = {.text = "no highlight is picked: click on one first"};
    return Edit::none;
  }
  store_keys(state.scene, controls_of(state.scene, *state.picked, *highlight), highlight->controls,
             state.clock.time_s());
  return Edit::done;
}

void draw_highlight_handles(const HighlightName& picked, const std::vector<world::WorldMesh>& meshes,
                            const Screen& screen) {
  const DrawnHighlight* highlight = find_highlight(meshes, picked);
  if (highlight == nullptr) return;
  const highlights::Projector box = box_in_world(meshes, picked, *highlight);
  const OverlayPainter painter(screen);
  std::vector<glm::dvec2> outline;
  for (const glm::dvec3& corner : corners_of(box)) {
    const std::optional<glm::dvec2> place_px = pixel_of(screen, corner);
    if (!place_px) return;
    outline.push_back(*place_px);
  }
  const std::vector<HandlePlace> places = handle_places(screen, box);
  const auto place_of = [&](Handle handle) {
    return std::find_if(places.begin(), places.end(),
                        [&](const HandlePlace& place) { return place.handle == handle; });
  };
  const auto knob = place_of(Handle::rotate), stem = place_of(Handle::height);
  for (const auto& [colour, width_px] : {std::pair(handle_shade, 3.0), {line_colour, 1.0}}) {
    painter.outline(outline, colour, width_px);
    if (knob != places.end() && stem != places.end())
      painter.line(knob->place_px, stem->place_px, colour, width_px);
  }
  for (const HandlePlace& place : places) draw_handle(painter, place);
  if (const std::optional<Handle> handle = handle_at(places, painter.pointer()))
    explain_handle(handle_help(*handle));
}

}  // namespace offing::present
