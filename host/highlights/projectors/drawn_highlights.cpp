#include "host/highlights/projectors/drawn_highlights.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "host/highlights/search/highlight_points.h"
#include "host/highlights/search/surface_place.h"
#include "host/highlights/search/tangent_axes.h"
#include "host/highlights/tracks/nearest_place.h"
#include "host/highlights/tracks/track_motion.h"

namespace offing::highlights {
namespace {

/// A place of a surface as if a highlight stood there: its normal and curvatures, interpolated as the search
/// for highlights does. n_dot_h, light and orientation are those of a point made by default.
HighlightPoint pinned_point(const HighlightSurface& surface, const SurfacePlace& place) {
  HighlightPoint point;
  point.face = place.face;
  point.weights = place.weights;
  point.position_m = position_at(surface, place);
  point.normal = normal_at(surface, place);
  // Directions are lines: they are mixed as arrows of twice their angle, each as long as half the difference
  // of the curvatures there.
  const TangentAxes axes = tangent_axes(point.normal);
  const VertexCurvatures& curvatures = surface.curvatures();
  double mean = 0.0, twice_cosine = 0.0, twice_sine = 0.0;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t vertex = surface.mesh().faces[place.face][static_cast<std::size_t>(i)];
    const double k_max = curvatures.k_max_per_m[vertex], k_min = curvatures.k_min_per_m[vertex];
    const double x = glm::dot(curvatures.e_max[vertex], axes.right);
    const double y = glm::dot(curvatures.e_max[vertex], axes.up);
    const double deviation = place.weights[i] * 0.5 * (k_max - k_min) / std::max(x * x + y * y, 1e-12);
    mean += place.weights[i] * 0.5 * (k_max + k_min);
    twice_cosine += deviation * (x * x - y * y);
    twice_sine += deviation * 2.0 * x * y;
  }
  const double deviation = std::hypot(twice_cosine, twice_sine);
  const double angle_rad = 0.5 * std::atan2(twice_sine, twice_cosine);
  point.e_max = std::cos(angle_rad) * axes.right + std::sin(angle_rad) * axes.up;
  point.k_max_per_m = mean + deviation;
  point.k_min_per_m = mean - deviation;
  return point;
}

/// [tracks] How much of each a rule for the nearest is for: as the state has it, or as it is now.
std::vector<double> shares_of(const HighlightSurface& surface, const NearestPlace& place,
                              const TrackState& state) {
  const auto known = std::find(state.places.begin(), state.places.end(), place);
  if (known == state.places.end()) return shares_nearest(surface, on_surface(surface, place), state.tracks);
  const auto index = static_cast<std::size_t>(known - state.places.begin());
  std::vector<double> shares;
  for (const HighlightTrack& track : state.tracks) shares.push_back(track.nearest[index]);
  return shares;
}

const HighlightRule as_found;

}  // namespace

HighlightDrawing::HighlightDrawing(const HighlightSurface& surface, const HighlightSize& size)
    : surface_(&surface), size_(with_cap(size, surface)), regions_(surface) {
  require_valid(size);
}

void HighlightDrawing::update(const TrackState& state, const std::vector<HighlightRule>& rules,
                              int light_count) {
  for (const HighlightRule& rule : rules) require_valid(rule);
  highlights_.clear();
  faces_.clear();
  pins_.resize(rules.size());
  masks_.resize(rules.size());
  nearest_.clear();
  for (const HighlightRule& rule : rules) {
    nearest_.emplace_back();
    if (rule.nearest_m && !rule.pin_m)
      nearest_.back() = shares_of(*surface_, {*rule.nearest_m, rule.light}, state);
  }
  for (std::size_t i = 0; i < state.tracks.size(); ++i) {
    const HighlightTrack& track = state.tracks[i];
    if (!(track.opacity > 0.0)) continue;
    set_looks(track, i, rules);
    for (const Look& look : looks_) {
      const HighlightRule& rule = look.rule < 0 ? as_found : rules[static_cast<std::size_t>(look.rule)];
      add({.id = track.id,
           .rule = look.rule,
           .light = track.point.light,
           .opacity = track.opacity * look.weight,
           .projector = track.projector,
           .place = place_of_face_near(*surface_, track.seed_face, track.projector.centre_m),
           .controls = rule.controls},
          rule);
    }
  }
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const int light = rules[i].light.value_or(0);
    if (rules[i].pin_m && light >= 0 && light < light_count) add_pin(rules[i], static_cast<int>(i));
  }
}

void HighlightDrawing::set_looks(const HighlightTrack& track, std::size_t index,
                                 const std::vector<HighlightRule>& rules) {
  looks_.assign(1, {-1, 1.0});
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i].pin_m || (rules[i].light && *rules[i].light != track.point.light)) continue;
    const double share = rules[i].nearest_m ? nearest_[i][index] : 1.0;
    if (share == 0.0) continue;
    for (Look& look : looks_) look.weight *= 1.0 - share;
    std::erase_if(looks_, [](const Look& look) { return look.weight <= 0.0; });
    looks_.push_back({static_cast<int>(i), share});
  }
}

const SurfacePlace& HighlightDrawing::nearest_to(const glm::dvec3& point_m, int rule,
                                                 RulePlaces& known) const {
  std::optional<RulePlace>& place = known[static_cast<std::size_t>(rule)];
  if (!place || place->point_m != point_m) place = RulePlace{point_m, nearest_place(*surface_, point_m)};
  return place->nearest;
}

void HighlightDrawing::add_pin(const HighlightRule& rule, int index) {
  const SurfacePlace& place = nearest_to(*rule.pin_m, index, pins_);
  add({.id = first_pin_id + static_cast<std::uint64_t>(index),
       .rule = index,
       .light = rule.light.value_or(0),
       .opacity = 1.0,
       .projector = first_projector(*surface_, pinned_point(*surface_, place), size_),
       .place = place,
       .controls = rule.controls},
      rule);
}

void HighlightDrawing::add(const DrawnHighlight& highlight, const HighlightRule& rule) {
  const HighlightControls& controls = rule.controls;
  DrawnHighlight drawn = highlight;
  drawn.opacity *= controls.opacity;
  if (!(drawn.opacity > 0.0)) return;
  const Projector& box = highlight.projector;
  const glm::dvec2 half_widths_m = 0.5 * glm::dvec2(box.width_m, box.height_m);
  PlacedProjector placed =
      moved(*surface_, {highlight.projector, highlight.place}, controls.offset * half_widths_m);
  placed.projector = reshaped(placed.projector, controls);
  drawn.found = highlight.projector;
  drawn.found_at_rest_m = at_rest(*surface_, highlight.place, highlight.projector.centre_m);
  drawn.whole = placed.projector;
  for (drawn.copy = 0; drawn.copy < controls.split; ++drawn.copy) {
    const CopyPlace share = copy_place(controls, drawn.copy);
    PlacedProjector copy = moved(*surface_, placed, {share.middle * placed.projector.width_m, 0.0});
    copy.projector.width_m *= share.width;
    drawn.projector = copy.projector;
    drawn.place = copy.place;
    add_copy(drawn, rule);
  }
}

void HighlightDrawing::add_copy(const DrawnHighlight& highlight, const HighlightRule& rule) {
  const std::size_t first = faces_.size();
  regions_.find(highlight.projector, highlight.place.face, faces_);
  keep_masked(rule, highlight.rule, first);
  highlights_.push_back(highlight);
  highlights_.back().first_face = first;
  highlights_.back().face_count = faces_.size() - first;
}

void HighlightDrawing::keep_masked(const HighlightRule& rule, int index, std::size_t first_face) {
  if (!rule.mask_m) return;
  const TriangleMesh& mesh = surface_->mesh();
  const glm::dvec3 mask_m = carried(*surface_, nearest_to(*rule.mask_m, index, masks_), *rule.mask_m);
  const auto is_beyond = [&](std::uint32_t face) {
    const TriangleIndices& corners = mesh.faces[face];
    return std::none_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
      return glm::distance(mesh.positions_m[corner], mask_m) <= rule.mask_radius_m;
    });
  };
  const auto first = faces_.begin() + static_cast<std::ptrdiff_t>(first_face);
  faces_.erase(std::remove_if(first, faces_.end(), is_beyond), faces_.end());
}

}  // namespace offing::highlights
