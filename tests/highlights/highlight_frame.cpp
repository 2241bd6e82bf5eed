// Finds the faces of tracks that can be seen.
#include "tests/highlights/highlight_frame.h"

#include <cstddef>

namespace offing::highlights {

void make_frame(const std::vector<HighlightTrack>& tracks, RegionSearch& regions, HighlightFrame& frame) {
  frame.highlights.clear();
  frame.faces.clear();
  for (const HighlightTrack& track : tracks) {
    if (!(track.opacity > 0.0)) continue;
    const std::size_t first = frame.faces.size();
    regions.find(track.projector, track.seed_face, frame.faces);
    frame.highlights.push_back({.id = track.id,
                                .light = track.point.light,
                                .opacity = track.opacity,
                                .projector = track.projector,
                                .first_face = first,
                                .face_count = frame.faces.size() - first});
  }
}

}  // namespace offing::highlights
