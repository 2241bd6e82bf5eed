#pragma once

#include <string>

#include "present/panels/panels.h"
#include "present/passes/live_sea.h"
#include "present/view_options.h"

namespace offing::present {

// What a window begins with.

/// As the list of scenes has the one that is open.
ListedScene listed(const ViewOptions& options);
/// What a scene is first saved as.
std::string first_save_name(const std::string& scene_name);
std::string title(const ViewOptions& options);
/// As large as the options say, else as the last window was left; as usual for a recording.
WindowSettings window_settings(const ViewOptions& options, const WindowExtent& last);
/// `quality`: of the first picture.
LiveSeaSettings sea_settings(const ViewOptions& options, const GlCapabilities& capabilities,
                             const CancelToken& cancel, const Quality& quality);
/// With the camera of the sea's scene, which the ground may have placed.
ViewState start_state(const ViewOptions& options, const LiveSea& sea);
/// Frames a second that are kept by quality; 0: none.
float start_kept_hz(const ViewOptions& options, const GlCapabilities& capabilities);
/// The level of quality_levels that a window begins with: a coarse one where the CPU draws and a rate is
/// kept, so that there is soon something to see.
std::size_t start_level(const ViewOptions& options, const GlCapabilities& capabilities);

}  // namespace offing::present
