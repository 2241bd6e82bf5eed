#pragma once

#include <functional>
#include <vector>

#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/tracks/highlight_track.h"

namespace offing::highlights {

/// How much of a highlight its light reaches where it is shown: 0 ... 1. It is not asked about one that would
/// not be seen in the light either. Empty: all of each.
using LitShare = std::function<double(const HighlightTrack& track)>;

/// What highlights are shown when nothing was shown before: one for each point, as opaque as it is lit.
TrackState first_state(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
                       const TrackOptions& options, const LitShare& lit_share = {});

/// One step on (H10, H11 of docs/sources.md). Points become those of the tracks of their light and
/// orientation that expect them nearest, pair by pair from the nearest on: humps and saddles are born and die
/// in pairs and are never taken for one another. What is left of tracks fades out where it is, what is left
/// of points fades in. Of several that the eye sees as one, one is shown; where its point ends it goes over
/// to that of another. What comes into a shadow fades. With the lighting that the points are of, limits grow
/// where H turns steadily.
void advance(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
             const TrackOptions& options, TrackState& state, const LitShare& lit_share = {},
             const Lighting* lighting = nullptr);

}  // namespace offing::highlights
