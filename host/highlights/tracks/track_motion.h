#pragma once

#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/tracks/highlight_track.h"

namespace offing::highlights {

/// The projector of a point that was not there before: of both ways to turn it (directions of curvature are
/// lines) that whose up looks more upward in the mesh.
Projector first_projector(const HighlightSurface& surface, const HighlightPoint& point,
                          const HighlightSize& size);

/// Moves, turns and scales what is shown of a track toward its point by one step, within the limits. Where
/// the curvatures are too alike to have directions, the axes only tilt with the normal.
void follow_point(const HighlightSurface& surface, const TrackOptions& options, HighlightTrack& track);

}  // namespace offing::highlights
