#pragma once

#include <vector>

#include "host/highlights/highlight_surface.h"
#include "host/highlights/highlight_track.h"

namespace offing::highlights {

/// What highlights are shown when nothing was shown before: one of full opacity for each point.
TrackState first_state(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
                       const TrackOptions& options);

/// One step on (H10, H11 of docs/sources.md). Points become those of the tracks of their lamp and orientation
/// that expect them nearest, pair by pair from the nearest on: humps and saddles are born and die in pairs
/// and are never taken for one another. What is left of tracks fades out where it is, what is left of points
/// fades in. Of several in one region the oldest is shown; the others blend in as they part.
void advance(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
             const TrackOptions& options, TrackState& state);

}  // namespace offing::highlights
