#pragma once

#include <optional>

#include "present/editing/cloud_picker.h"
#include "present/panels/panels.h"

namespace offing::present {

/// Draws balls, what is picked of clouds with its handles, and the box that is being drawn, behind ImGui's
/// windows.
void draw_cloud_overlay(const ViewState& state, const world::WorldClouds* view, const Screen& screen,
                        const std::optional<ClipBox>& box);

}  // namespace offing::present
