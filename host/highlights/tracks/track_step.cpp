#include "host/highlights/tracks/track_step.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/parameter_check.h"
#include "host/highlights/search/surface_place.h"
#include "host/highlights/tracks/nearest_place.h"
#include "host/highlights/tracks/track_motion.h"

namespace offing::highlights {
namespace {

// A highlight that is fading out is taken up again by a point that appears this much nearer than the one
// expected.
constexpr double revival_share = 0.4;

HighlightTrack born(const HighlightSurface& surface, const HighlightPoint& point, const TrackOptions& options,
                    std::uint64_t id) {
  HighlightTrack track;
  track.id = id;
  track.point = point;
  track.projector = first_projector(surface, point, options.size);
  track.seed_face = point.face;
  return track;
}

/// Points of the step before and what is shown of them go with the surface where that has been deformed
/// since.
void go_along(const HighlightSurface& surface, HighlightTrack& track) {
  const glm::dvec3 place_m = place_on(surface, track.point.face, track.point.weights);
  track.projector.centre_m += place_m - track.point.position_m;
  track.point.position_m = place_m;
}

/// How far H has turned over the surface in this step, where the highlight was in the last one.
void measure_turn(const HighlightSurface& surface, const Lighting* lighting, HighlightTrack& track) {
  double turn_rad = 0.0;
  const auto light = static_cast<std::size_t>(track.point.light);
  if (lighting != nullptr && light < lighting->lights.size() && track.state == HighlightTrack::State::alive) {
    const glm::dvec3 normal = normal_at(surface, {track.point.face, track.point.weights});
    const glm::dvec3 half = half_vector(lighting->eye, lighting->lights[light], track.point.position_m);
    turn_rad = std::atan2(glm::length(glm::cross(normal, half)), glm::dot(normal, half));
  }
  track.steady_turn_rad = std::min(turn_rad, track.turn_rad);
  track.turn_rad = turn_rad;
}

/// Places in the order of their x, so that those near another are found without looking at all: noisy scans
/// have thousands of highlights.
class PlacesAlongX {
 public:
  void add(std::size_t index, const glm::dvec3& place_m) { places_.emplace_back(place_m.x, index); }
  /// Once, after all are added.
  void sort() { std::sort(places_.begin(), places_.end()); }

  /// Visits the indices of all places that are within the reach along x, and so all within it.
  template <class Visit>
  void visit_near(const glm::dvec3& place_m, double reach_m, const Visit& visit) const {
    auto place =
        std::lower_bound(places_.begin(), places_.end(), std::pair(place_m.x - reach_m, std::size_t{0}));
    for (; place != places_.end() && place->first <= place_m.x + reach_m; ++place) visit(place->second);
  }

 private:
  std::vector<std::pair<double, std::size_t>> places_;  // x, index
};

struct Pair {
  double distance_m;
  std::size_t track, point;
};

/// Every track with every point that it may have come to.
std::vector<Pair> possible_pairs(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
                                 const TrackOptions& options, const std::vector<HighlightTrack>& tracks) {
  const double jump_m = options.jump_share * surface.diagonal_m();
  const double lag_m = options.lag_share * surface.diagonal_m();
  PlacesAlongX places;
  for (std::size_t p = 0; p < points.size(); ++p) places.add(p, points[p].position_m);
  places.sort();
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const HighlightTrack& track = tracks[t];
    const bool is_alive = track.state == HighlightTrack::State::alive;
    const glm::dvec3 expected_m = track.point.position_m + (is_alive ? track.way_m : glm::dvec3(0.0));
    const double reach_m = is_alive ? jump_m : revival_share * jump_m;
    places.visit_near(expected_m, reach_m, [&](std::size_t p) {
      if (points[p].light != track.point.light || points[p].orientation != track.point.orientation) return;
      const double distance_m = glm::distance(points[p].position_m, expected_m);
      const bool is_in_sight = glm::distance(points[p].position_m, track.projector.centre_m) <= lag_m;
      if (distance_m <= reach_m && is_in_sight) pairs.push_back({distance_m, t, p});
    });
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.distance_m, a.track, a.point) < std::tie(b.distance_m, b.track, b.point);
  });
  return pairs;
}

void match(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
           const TrackOptions& options, TrackState& state) {
  std::vector<HighlightTrack>& tracks = state.tracks;
  std::vector<std::uint8_t> track_is_taken(tracks.size(), 0), point_is_taken(points.size(), 0);
  for (const Pair& pair : possible_pairs(surface, points, options, tracks)) {
    if (track_is_taken[pair.track] != 0 || point_is_taken[pair.point] != 0) continue;
    track_is_taken[pair.track] = point_is_taken[pair.point] = 1;
    HighlightTrack& track = tracks[pair.track];
    track.way_m = track.state == HighlightTrack::State::alive
                      ? points[pair.point].position_m - track.point.position_m
                      : glm::dvec3(0.0);
    track.point = points[pair.point];
    track.state = HighlightTrack::State::alive;
  }
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (track_is_taken[t] == 0) tracks[t].state = HighlightTrack::State::fading;
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (point_is_taken[p] == 0) tracks.push_back(born(surface, points[p], options, state.next_id++));
  }
}

/// How deep the middle of one lies in the other's box, of both ways the deeper: 0 in the middle, 1 at the
/// rim.
double depth_apart(const Projector& a, const Projector& b) {
  const glm::dvec3 way_m = b.centre_m - a.centre_m;
  const auto apart = [&](const Projector& box) {
    const glm::dvec3 q(glm::dot(way_m, box.right) / box.width_m, glm::dot(way_m, box.up) / box.height_m,
                       glm::dot(way_m, box.normal) / std::max(box.width_m, box.height_m));
    return 2.0 * glm::length(q);
  };
  return std::min(apart(a), apart(b));
}

bool is_visible(const HighlightTrack& track) {
  return track.opacity > 0.0;
}

/// Whether the eye sees two of one light as one: nearer than the distances from which on they are parted, or
/// than those within which they unite.
bool are_one(const HighlightSurface& surface, const TrackOptions& options, const HighlightTrack& a,
             const HighlightTrack& b, bool until_parted) {
  if (a.point.light != b.point.light) return false;
  const double share = until_parted ? options.part_share : options.unite_share;
  const double depth = until_parted ? options.part_depth : options.unite_depth;
  return glm::distance(a.projector.centre_m, b.projector.centre_m) < share * surface.diagonal_m() ||
         depth_apart(a.projector, b.projector) < depth;
}

/// A visible track whose point is lost goes over to the nearest point that the eye takes for the same
/// highlight, if that shows nothing of its own.
void inherit(const HighlightSurface& surface, const TrackOptions& options, TrackState& state) {
  std::vector<HighlightTrack>& tracks = state.tracks;
  std::vector<std::uint8_t> is_taken(tracks.size(), 0);
  for (HighlightTrack& track : tracks) {
    if (track.state == HighlightTrack::State::alive || track.is_merged || !is_visible(track)) continue;
    std::size_t nearest = tracks.size();
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      const HighlightTrack& heir = tracks[i];
      if (heir.state != HighlightTrack::State::alive || is_visible(heir) || is_taken[i] != 0) continue;
      const double distance_m = glm::distance(heir.point.position_m, track.projector.centre_m);
      if (distance_m >= least_m || !are_one(surface, options, track, heir, true)) continue;
      least_m = distance_m;
      nearest = i;
    }
    if (nearest == tracks.size()) continue;
    is_taken[nearest] = 1;
    track.point = tracks[nearest].point;
    track.way_m = tracks[nearest].way_m;
    track.turn_rad = tracks[nearest].turn_rad;
    track.steady_turn_rad = tracks[nearest].steady_turn_rad;
    track.state = HighlightTrack::State::alive;
  }
  std::size_t index = 0;
  std::erase_if(tracks, [&](const HighlightTrack&) { return is_taken[index++] != 0; });
}

/// Of those that are one to the eye, the visible one that is the oldest leads, and the others are merged with
/// it. Where none is visible, it is the largest.
void merge(const HighlightSurface& surface, const TrackOptions& options,
           std::vector<HighlightTrack>& tracks) {
  std::vector<HighlightTrack*> by_rank;
  for (HighlightTrack& track : tracks) by_rank.push_back(&track);
  const auto others = std::ranges::stable_partition(
      by_rank, [](const HighlightTrack* track) { return is_visible(*track) && !track->is_merged; });
  std::ranges::stable_sort(others, std::ranges::greater{}, [](const HighlightTrack* track) {
    return track->projector.width_m * track->projector.height_m;
  });
  std::vector<const HighlightTrack*> leaders;
  for (HighlightTrack* track : by_rank) {
    const bool until_parted = track->is_merged || !is_visible(*track);
    const bool is_young = is_visible(*track) && track->shown_s < options.least_life_s && !track->is_merged;
    track->is_merged = !is_young && std::ranges::any_of(leaders, [&](const HighlightTrack* leader) {
      return are_one(surface, options, *leader, *track, until_parted);
    });
    // What is in the dark or ends leaves its place to others.
    const bool leads = !track->is_merged && !track->is_dark && track->state == HighlightTrack::State::alive;
    if (leads) leaders.push_back(track);
  }
}

/// How opaque a track is where nothing has to go by degrees. In the dark it is what it was: rays cost more
/// than all the rest.
double wanted_opacity(const LitShare& lit_share, const TrackOptions& options, HighlightTrack& track) {
  const double in_light = track.presence * track.share;
  if (in_light > 0.0 && lit_share) track.lit = lit_share(track);
  if (is_visible(track) && track.shown_s < options.least_life_s)
    return in_light * std::max(track.lit, options.dark_share);
  track.is_dark = track.lit < (track.is_dark ? options.lit_share : options.dark_share);
  return track.is_dark ? 0.0 : in_light * track.lit;
}

bool is_over(const HighlightTrack& track) {
  return track.state == HighlightTrack::State::fading && track.presence <= 0.0 && track.opacity <= 0.0;
}

}  // namespace

void require_valid(const TrackOptions& options) {
  require_within("highlights.step_s", options.step_s, 1e-4, 1.0);
  require_valid(options.size);
  require_within("highlights.move_per_s", options.limits.move_per_s, 1e-3, 1e3);
  require_within("highlights.scale_per_s", options.limits.scale_per_s, 1e-3, 1e3);
  require_within("highlights.turn_radps", options.limits.turn_radps, 1e-3, 1e3);
  require_within("highlights.fade_per_s", options.limits.fade_per_s, 1e-3, 1e3);
  require_within("highlights.move_per_rad", options.limits.move_per_rad, 0.0, 1e3);
  require_within("highlights.turn_per_rad", options.limits.turn_per_rad, 0.0, 1e3);
  require_within("highlights.jump_share", options.jump_share, 0.0, 1.0);
  require_within("highlights.lag_share", options.lag_share, 0.0, 1.0);
  require_within("highlights.unite_depth", options.unite_depth, 0.0, options.part_depth);
  require_within("highlights.part_depth", options.part_depth, 0.0, 100.0);
  require_within("highlights.unite_share", options.unite_share, 0.0, options.part_share);
  require_within("highlights.part_share", options.part_share, 0.0, 1.0);
  require_within("highlights.settle_s", options.settle_s, 0.0, 1e3);
  require_within("highlights.dark_share", options.dark_share, 0.0, options.lit_share);
  require_within("highlights.lit_share", options.lit_share, 0.0, 1.0);
  require_within("highlights.least_life_s", options.least_life_s, 0.0, 1e3);
  require_within("highlights.key_steps", options.key_steps, 1, 1e6);
}

TrackState first_state(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
                       const TrackOptions& options, const LitShare& lit_share) {
  TrackState state;
  for (const HighlightPoint& point : points) {
    state.tracks.push_back(born(surface, point, options, state.next_id++));
    state.tracks.back().presence = 1.0;
  }
  merge(surface, options, state.tracks);
  for (HighlightTrack& track : state.tracks) {
    track.share = track.is_merged ? 0.0 : 1.0;
    track.opacity = wanted_opacity(lit_share, options, track);
  }
  return state;
}

void advance(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
             const TrackOptions& options, TrackState& state, const LitShare& lit_share,
             const Lighting* lighting) {
  for (HighlightTrack& track : state.tracks) {
    go_along(surface, track);
    measure_turn(surface, lighting, track);
  }
  match(surface, points, options, state);
  inherit(surface, options, state);
  const double fade = options.limits.fade_per_s * options.step_s;
  for (HighlightTrack& track : state.tracks) {
    const bool is_alive = track.state == HighlightTrack::State::alive;
    const bool stays = is_alive || (is_visible(track) && track.shown_s < options.least_life_s);
    track.age_s += options.step_s;
    if (!stays || track.presence > 0.0 || track.age_s > options.settle_s)
      track.presence = std::clamp(track.presence + (stays ? fade : -fade), 0.0, 1.0);
    if (is_alive) follow_point(surface, options, track);
  }
  merge(surface, options, state.tracks);
  std::vector<double> opacities_before;  // [tracks]
  for (HighlightTrack& track : state.tracks) {
    opacities_before.push_back(track.opacity);
    const double share = track.is_merged ? 0.0 : 1.0;
    track.share = is_visible(track) ? track.share + std::clamp(share - track.share, -fade, fade) : share;
    track.opacity += std::clamp(wanted_opacity(lit_share, options, track) - track.opacity, -fade, fade);
    track.shown_s = is_visible(track) ? track.shown_s + options.step_s : 0.0;
  }
  follow_places(surface, fade, opacities_before, state);
  std::erase_if(state.tracks, is_over);
  ++state.step;
}

}  // namespace offing::highlights
