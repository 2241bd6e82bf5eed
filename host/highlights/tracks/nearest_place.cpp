#include "host/highlights/tracks/nearest_place.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

// Two highlights that differ by no more than this share of the diagonal in their distances share a place.
constexpr double nearness_share = 0.02;

bool is_of_light(const NearestPlace& place, const HighlightTrack& track) {
  return !place.light || *place.light == track.point.light;
}

/// What is not there, or is part of an older one, is farther than what is, by degrees: else a place would go
/// to what has just begun to appear. One in a shadow stays the nearest.
double distance_to(const glm::dvec3& place_m, const HighlightTrack& track, double diagonal_m) {
  return glm::distance(place_m, track.projector.centre_m) +
         2.0 * diagonal_m * (1.0 - track.presence * track.share);
}

/// The share nearest to the wanted one that fades neither the place's part of the opacity nor the rest by
/// more than `fade`. There is one, as the opacity itself changes by no more.
double limited(double share, double wanted, double opacity_before, double opacity, double fade) {
  if (!(opacity > 0.0)) return wanted;
  const double part = share * opacity_before, change = opacity - opacity_before;
  const double low = std::max(part, part + change) - fade, high = std::min(part, part + change) + fade;
  return std::clamp(std::clamp(wanted * opacity, low, high), 0.0, opacity) / opacity;
}

}  // namespace

std::vector<NearestPlace> nearest_places(const std::vector<HighlightRule>& rules) {
  std::vector<NearestPlace> places;
  for (const HighlightRule& rule : rules) {
    if (rule.pin_m || !rule.nearest_m) continue;
    const NearestPlace place{*rule.nearest_m, rule.light};
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
  return places;
}

NearestPlace on_surface(const HighlightSurface& surface, NearestPlace place) {
  if (!surface.mesh().faces.empty()) place.nearest = nearest_place(surface, place.place_m);
  return place;
}

std::vector<double> shares_nearest(const HighlightSurface& surface, const NearestPlace& place,
                                   const std::vector<HighlightTrack>& tracks) {
  constexpr double none_m = std::numeric_limits<double>::infinity();
  const double diagonal_m = surface.diagonal_m();
  const glm::dvec3 place_m = carried(surface, place.nearest, place.place_m);
  std::vector<double> distances_m;  // [tracks]
  double least_m = none_m, second_m = none_m;
  for (const HighlightTrack& track : tracks) {
    const double distance_m = is_of_light(place, track) ? distance_to(place_m, track, diagonal_m) : none_m;
    distances_m.push_back(distance_m);
    second_m = std::min(second_m, std::max(distance_m, least_m));
    least_m = std::min(least_m, distance_m);
  }
  const double band_m = nearness_share * diagonal_m;
  std::vector<double> shares;
  for (const double distance_m : distances_m) {
    const double other_m = distance_m > least_m ? least_m : second_m;
    if (distance_m == none_m || distance_m - other_m >= band_m) {
      shares.push_back(0.0);
    } else {
      shares.push_back(
          other_m - distance_m >= band_m ? 1.0 : glm::smoothstep(-band_m, band_m, other_m - distance_m));
    }
  }
  return shares;
}

void take_places(const HighlightSurface& surface, const std::vector<NearestPlace>& places,
                 TrackState& state) {
  if (places == state.places) return;
  std::vector<NearestPlace> all;
  std::vector<std::vector<double>> taken(state.tracks.size());  // [tracks][places]
  for (const NearestPlace& place : places) {
    const auto known = std::find(state.places.begin(), state.places.end(), place);
    const bool is_known = known != state.places.end();
    const auto index = static_cast<std::size_t>(known - state.places.begin());
    all.push_back(is_known ? *known : on_surface(surface, place));
    const std::vector<double> anew = shares_nearest(surface, all.back(), state.tracks);
    for (std::size_t i = 0; i < taken.size(); ++i)
      taken[i].push_back(is_known ? state.tracks[i].nearest[index] : anew[i]);
  }
  for (std::size_t i = 0; i < taken.size(); ++i) state.tracks[i].nearest = std::move(taken[i]);
  state.places = std::move(all);
}

void follow_places(const HighlightSurface& surface, double fade, std::span<const double> opacities_before,
                   TrackState& state) {
  for (std::size_t place = 0; place < state.places.size(); ++place) {
    const std::vector<double> wanted = shares_nearest(surface, state.places[place], state.tracks);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      HighlightTrack& track = state.tracks[i];
      track.nearest.resize(state.places.size(), 0.0);
      track.nearest[place] =
          limited(track.nearest[place], wanted[i], opacities_before[i], track.opacity, fade);
    }
  }
}

}  // namespace offing::highlights
