#pragma once

#include "present/panels/panels.h"

namespace offing::present {

/// Draws the list of what the scene has, with buttons that add, duplicate and delete, and the values of what
/// is selected. A click selects, a double click renames or, on a bookmark, goes there.
void draw_outliner(ViewState& state, PanelEdits& edits);

}  // namespace offing::present
