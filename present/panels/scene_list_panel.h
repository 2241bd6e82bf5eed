#pragma once

#include <optional>

#include "present/window/scene_list.h"

namespace offing::present {

/// Draws the list of scenes that can be opened, with a mark at the open one; the one that was clicked. Files
/// beside the open one are looked for anew when the list is unfolded.
std::optional<ListedScene> draw_scene_list(SceneList& list, const ListedScene& open);

}  // namespace offing::present
