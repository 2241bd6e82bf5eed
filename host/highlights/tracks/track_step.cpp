#include "host/highlights/tracks/track_step.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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
// Two highlights are one region while the middle of one is this deep in the other's box (0 middle, 1 rim);
// they are two from `parted` on.
constexpr double united = 0.25, parted = 0.75;

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

/// What each may show beside older ones of its light.
void share_regions(std::vector<HighlightTrack>& tracks) {
  PlacesAlongX places;
  double widest_m = 0.0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Projector& box = tracks[i].projector;
    places.add(i, box.centre_m);
    widest_m = std::max({widest_m, box.width_m, box.height_m});
  }
  places.sort();
  for (std::size_t younger = 0; younger < tracks.size(); ++younger) {
    HighlightTrack& track = tracks[younger];
    track.share = 1.0;
    places.visit_near(track.projector.centre_m, 0.5 * parted * widest_m, [&](std::size_t older) {
      const HighlightTrack& other = tracks[older];
      if (older >= younger || other.point.light != track.point.light) return;
      const double overlap =
          1.0 - glm::smoothstep(united, parted, depth_apart(other.projector, track.projector));
      track.share *= 1.0 - overlap * other.presence * other.share;
    });
  }
}

/// How opaque a track is where nothing has to go by degrees. In the dark it is what it was: rays cost more
/// than all the rest.
double wanted_opacity(const LitShare& lit_share, HighlightTrack& track) {
  const double in_light = track.presence * track.share;
  if (in_light > 0.0 && lit_share) track.lit = lit_share(track);
  return in_light * track.lit;
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
  require_within("highlights.key_steps", options.key_steps, 1, 1e6);
}

TrackState first_state(const HighlightSurface& surface, const std::vector<HighlightPoint>& points,
                       const TrackOptions& options, const LitShare& lit_share) {
  TrackState state;
  for (const HighlightPoint& point : points) {
    state.tracks.push_back(born(surface, point, options, state.next_id++));
    state.tracks.back().presence = 1.0;
  }
  share_regions(state.tracks);
  for (HighlightTrack& track : state.tracks) track.opacity = wanted_opacity(lit_share, track);
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
  const double fade = options.limits.fade_per_s * options.step_s;
  for (HighlightTrack& track : state.tracks) {
    const bool is_alive = track.state == HighlightTrack::State::alive;
    track.presence = std::clamp(track.presence + (is_alive ? fade : -fade), 0.0, 1.0);
    if (is_alive) follow_point(surface, options, track);
  }
  share_regions(state.tracks);
  std::vector<double> opacities_before;  // [tracks]
  for (HighlightTrack& track : state.tracks) {
    opacities_before.push_back(track.opacity);
    track.opacity += std::clamp(wanted_opacity(lit_share, track) - track.opacity, -fade, fade);
  }
  follow_places(surface.diagonal_m(), fade, opacities_before, state);
  std::erase_if(state.tracks, is_over);
  ++state.step;
}

}  // namespace offing::highlights
