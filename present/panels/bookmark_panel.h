#pragma once

#include "present/panels/panels.h"

namespace offing::present {

/// Draws what the panel of bookmarks holds: for each one to go there, to set it to this view, to remove and
/// to name it, and its numbers folded away; and to add this view. Goes there by the camera of the state's
/// scene.
void draw_bookmarks(ViewState& state, PanelEdits& edits);

}  // namespace offing::present
