#pragma once

#include "present/panels/panels.h"
#include "present/passes/live_sea.h"

namespace offing::present {

/// Draws the panel of the cloud editor, of a scene that has clouds or gets some by a tool: what clicks do,
/// values of what is picked, the sun, and what the clouds cost. Says how far an edit of the scene has come.
Edit draw_cloud_panel(ViewState& state, LiveSea& sea);

}  // namespace offing::present
