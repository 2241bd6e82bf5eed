#pragma once

#include "present/panels/panels.h"

namespace offing::present {

/// Draws the list of what the scene has, with buttons that add, duplicate and delete. A click selects, a
/// double click renames or, on a bookmark, goes there.
void draw_outliner(ViewState& state, PanelEdits& edits);
/// Draws the values of what is selected.
void draw_selected_values(ViewState& state, PanelEdits& edits);

/// Whether the panel of a group has a place below the list: while something is selected, only if it says more
/// of that.
bool is_shown_with_selection(const ViewState& state, scene::ParameterGroup group);

}  // namespace offing::present
