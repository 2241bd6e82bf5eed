#pragma once

#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/tracks/highlight_track.h"

namespace offing::highlights {

/// What is shown between two steps that follow one another, at `share` (0 ... 1) of the way: places,
/// directions, sizes and opacities change evenly. So nothing changes faster than between steps, and a
/// highlight that moves evenly does so at every frame rate. The surface is as it is at that time. The
/// state's own numbers, and the points, are those of the step before.
TrackState tracks_between(const HighlightSurface& surface, const TrackState& before, const TrackState& after,
                          double share);

}  // namespace offing::highlights
