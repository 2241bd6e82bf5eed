#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/highlights/projectors/highlight_rule.h"
#include "host/highlights/tracks/highlight_track.h"

namespace offing::highlights {

/// Those of rules, each once.
std::vector<NearestPlace> nearest_places(const std::vector<HighlightRule>& rules);

/// [tracks] How much of each is nearest to a place where nothing has to go by degrees: 0 ... 1, 1 in all. A
/// second one that comes as near as the first, within 2 % of the diagonal, has half.
std::vector<double> shares_nearest(const HighlightSurface& surface, const NearestPlace& place,
                                   const std::vector<HighlightTrack>& tracks);

/// The place with the one nearest to it on the surface.
NearestPlace on_surface(const HighlightSurface& surface, NearestPlace place);

/// Gives a state these places in the stead of its own. Shares of those that it has stay, others are those of
/// shares_nearest() at once.
void take_places(const HighlightSurface& surface, const std::vector<NearestPlace>& places, TrackState& state);

/// Moves shares toward those of shares_nearest(), so that neither what is drawn of a track for a place nor
/// what is left of it fades by more than `fade`. `opacities_before` [tracks]: of the step before, which the
/// tracks' own differ from by no more than that.
void follow_places(const HighlightSurface& surface, double fade, std::span<const double> opacities_before,
                   TrackState& state);

}  // namespace offing::highlights
