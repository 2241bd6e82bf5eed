#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "host/highlights/projectors/highlight_rule.h"
#include "host/highlights/projectors/projector.h"
#include "host/highlights/search/lighting.h"
#include "present/editing/handle_geometry.h"

namespace offing::present {

/// What a hand can take hold of on a picked highlight: its middle; a knob above it; a corner; the middles of
/// its right and upper sides.
enum class Handle { move, rotate, scale, width, height };

/// A handle on the screen, in pixels from its upper left corner.
struct HandlePlace {
  Handle handle;
  glm::dvec2 place_px;
};

/// A box of a mesh in the world's axes.
highlights::Projector in_world(const highlights::Projector& box, const highlights::RigidMotion& mesh);

/// The handles of a box in the world's axes; those behind the eye are left out.
std::vector<HandlePlace> handle_places(const Screen& screen, const highlights::Projector& box);

/// What a handle does, as help on it.
const char* handle_help(Handle handle);

/// The corners of the box, anticlockwise.
std::vector<glm::dvec3> corners_of(const highlights::Projector& box);

/// The nearest handle within a hand's width (12 pixels).
std::optional<Handle> handle_at(const std::vector<HandlePlace>& places, glm::dvec2 pointer_px);

/// Where the ray through a point of the screen, in clip coordinates, meets the plane of a box: metres along
/// its right and up. Nothing where the plane is seen from the side or from behind.
std::optional<glm::dvec2> place_on_plane(const Screen& screen, const highlights::Projector& box,
                                         glm::dvec2 clip);

/// What a hand that turns or resizes makes of the controls that it found: it took hold at `from_m` of the
/// box's plane and is at `to_m` of it now. Values stay in their ranges.
highlights::HighlightControls pulled(const highlights::HighlightControls& controls, Handle handle,
                                     glm::dvec2 from_m, glm::dvec2 to_m);

/// Controls that bring a box `way_m` further along its own right and up, as far as the surface is flat.
/// `found` is the box before any control.
highlights::HighlightControls pushed(const highlights::HighlightControls& controls,
                                     const highlights::Projector& found, glm::dvec2 way_m);

}  // namespace offing::present
