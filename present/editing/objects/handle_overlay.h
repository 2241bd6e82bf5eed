#pragma once

#include <imgui.h>

#include "present/editing/objects/object_handles.h"

namespace offing::present {

/// What handles and outlines of what is selected are drawn in.
inline constexpr ImU32 selected_colour = IM_COL32(255, 200, 40, 255), handle_shade = IM_COL32(0, 0, 0, 160);

inline ImVec2 screen_point(glm::dvec2 place_px) {
  return {static_cast<float>(place_px.x), static_cast<float>(place_px.y)};
}

/// Draws the handles of a sphere.
void draw_object_handles(ImDrawList& list, const Screen& screen, const Sphere& sphere, HandleSet handles);

}  // namespace offing::present
