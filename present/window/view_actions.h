#pragma once

#include "present/editing/scene_editing.h"
#include "present/panels/panels.h"
#include "present/window/key_bindings.h"

namespace offing::present {

/// Does what a key asks of the view alone: panels, time and what is shown. False for all other actions.
bool change_view(ViewAction action, ViewState& state);

/// Does what a key asks of what is selected on a screen, or of the tool that edits clouds. False for
/// all other actions.
bool change_edits(ViewAction action, SceneEditing& editing, const Screen& screen);

}  // namespace offing::present
