// What is shown between two steps.
#include "host/highlights/tracks/tracks_between.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "host/highlights/search/nearest_face.h"

namespace offing::highlights {
namespace {

double even_ratio(double from_m, double to_m, double share) {
  return from_m * std::pow(to_m / from_m, share);
}

Projector projector_between(const Projector& before, const Projector& after, double share) {
  Projector result = before;
  result.centre_m = glm::mix(before.centre_m, after.centre_m, share);
  const auto axes = [](const Projector& box) {
    return glm::quat_cast(glm::dmat3(box.right, box.up, box.normal));
  };
  const glm::dmat3 turned = glm::mat3_cast(glm::normalize(glm::slerp(axes(before), axes(after), share)));
  result.right = turned[0];
  result.up = turned[1];
  result.normal = turned[2];
  result.width_m = even_ratio(before.width_m, after.width_m, share);
  result.height_m = even_ratio(before.height_m, after.height_m, share);
  return result;
}

HighlightTrack track_between(const HighlightSurface& surface, const HighlightTrack& before,
                             const HighlightTrack& after, double share) {
  HighlightTrack track = before;
  track.projector = projector_between(before.projector, after.projector, share);
  track.seed_face =
      nearest_face(surface, share < 0.5 ? before.seed_face : after.seed_face, track.projector.centre_m);
  track.presence = glm::mix(before.presence, after.presence, share);
  track.share = glm::mix(before.share, after.share, share);
  track.lit = glm::mix(before.lit, after.lit, share);
  track.opacity = glm::mix(before.opacity, after.opacity, share);
  for (std::size_t place = 0; place < track.nearest.size(); ++place)
    track.nearest[place] = glm::mix(before.nearest[place], after.nearest[place], share);
  return track;
}

/// One that is in one of the states only, where it is there: none of it is shown in the other.
HighlightTrack faded(HighlightTrack track, double share) {
  track.presence *= share;
  track.opacity *= share;
  return track;
}

}  // namespace

TrackState tracks_between(const HighlightSurface& surface, const TrackState& before, const TrackState& after,
                          double share) {
  TrackState state{.step = before.step, .next_id = after.next_id, .tracks = {}, .places = before.places};
  auto old = before.tracks.begin();
  auto now = after.tracks.begin();
  // Both are by id, and ids that are new come last.
  while (old != before.tracks.end() || now != after.tracks.end()) {
    const bool is_over = now == after.tracks.end() || (old != before.tracks.end() && old->id < now->id);
    const bool is_new = old == before.tracks.end();
    if (is_over) {
      state.tracks.push_back(faded(*old++, 1.0 - share));
    } else if (is_new) {
      state.tracks.push_back(faded(*now++, share));
    } else {
      state.tracks.push_back(track_between(surface, *old++, *now++, share));
    }
  }
  return state;
}

}  // namespace offing::highlights
