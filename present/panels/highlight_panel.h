#pragma once

#include <vector>

#include "host/world/world_mesh.h"
#include "present/panels/panels.h"

namespace offing::present {

/// Draws the panel of the picked highlight, if there is one: all its controls, as they are at the state's
/// time. Those with keyframes get one there when they are changed. Says how far an edit of the scene has
/// come.
Edit draw_highlight_panel(ViewState& state, const std::vector<world::WorldMesh>& meshes);

}  // namespace offing::present
