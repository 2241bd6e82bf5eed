#pragma once

#include "present/panels/panels.h"
#include "present/passes/live_sea.h"

namespace offing::present {

/// Draws the panel of the cloud editor while a cloud is selected, or clicks make clouds or pick parts of
/// them: what clicks do, values of picked balls and particles, the sun, and what the clouds cost. Says how
/// far an edit of the scene has come.
Edit draw_cloud_panel(ViewState& state, LiveSea& sea);

}  // namespace offing::present
