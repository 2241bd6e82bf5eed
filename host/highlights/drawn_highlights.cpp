#include "host/highlights/drawn_highlights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/highlights/pinned_point.h"
#include "host/highlights/track_motion.h"

namespace offing::highlights {
namespace {

// Two highlights that differ by no more than this share of the diagonal in their distances share a rule for
// the nearest.
constexpr double nearness_share = 0.02;

bool is_for_lamp(const HighlightRule& rule, const HighlightTrack& track) {
  return !rule.pin_m && (!rule.lamp || *rule.lamp == track.point.lamp);
}

/// Distance to the rule's place. What cannot be seen is farther than what can, by degrees: else a rule would
/// leap to what has just begun to appear.
double distance_to(const glm::dvec3& place_m, const HighlightTrack& track, double diagonal_m) {
  return glm::distance(place_m, track.projector.centre_m) + 2.0 * diagonal_m * (1.0 - track.opacity);
}

/// How much of a track a rule is for: 0 ... 1; those of all tracks next to one another add up to 1.
double share_of(const HighlightRule& rule, const std::vector<HighlightTrack>& tracks, std::size_t track,
                double diagonal_m) {
  if (!is_for_lamp(rule, tracks[track])) return 0.0;
  if (!rule.nearest_m) return 1.0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t other = 0; other < tracks.size(); ++other) {
    if (other == track || !is_for_lamp(rule, tracks[other])) continue;
    least_m = std::min(least_m, distance_to(*rule.nearest_m, tracks[other], diagonal_m));
  }
  const double ahead_m = least_m - distance_to(*rule.nearest_m, tracks[track], diagonal_m);
  const double band_m = nearness_share * diagonal_m;
  return ahead_m >= band_m ? 1.0 : glm::smoothstep(-band_m, band_m, ahead_m);
}

const HighlightRule as_found;

}  // namespace

DrawnHighlights::DrawnHighlights(const HighlightSurface& surface, const HighlightSize& size)
    : surface_(&surface), size_(size), regions_(surface) {
  projector_at({}, size);
}

void DrawnHighlights::update(const std::vector<HighlightTrack>& tracks,
                             const std::vector<HighlightRule>& rules, int lamp_count) {
  for (const HighlightRule& rule : rules) require_valid(rule);
  highlights_.clear();
  faces_.clear();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const HighlightTrack& track = tracks[i];
    if (!(track.opacity > 0.0)) continue;
    set_looks(tracks, rules, i);
    for (const Look& look : looks_) {
      const HighlightRule& rule = look.rule < 0 ? as_found : rules[static_cast<std::size_t>(look.rule)];
      add({.id = track.id,
           .rule = look.rule,
           .lamp = track.point.lamp,
           .opacity = track.opacity * look.weight,
           .projector = track.projector,
           .place = place_of_face_near(*surface_, track.seed_face, track.projector.centre_m),
           .controls = rule.controls},
          rule);
    }
  }
  pins_.resize(rules.size());
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const int lamp = rules[i].lamp.value_or(0);
    if (rules[i].pin_m && lamp >= 0 && lamp < lamp_count) add_pin(rules[i], static_cast<int>(i));
  }
}

void DrawnHighlights::set_looks(const std::vector<HighlightTrack>& tracks,
                                const std::vector<HighlightRule>& rules, std::size_t track) {
  looks_.assign(1, {-1, 1.0});
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const double share = share_of(rules[i], tracks, track, surface_->diagonal_m());
    if (share == 0.0) continue;
    for (Look& look : looks_) look.weight *= 1.0 - share;
    std::erase_if(looks_, [](const Look& look) { return look.weight <= 0.0; });
    looks_.push_back({static_cast<int>(i), share});
  }
}

void DrawnHighlights::add_pin(const HighlightRule& rule, int index) {
  std::optional<Pin>& pin = pins_[static_cast<std::size_t>(index)];
  if (!pin || pin->pin_m != *rule.pin_m) pin = Pin{*rule.pin_m, nearest_place(*surface_, *rule.pin_m)};
  add({.id = first_pin_id + static_cast<std::uint64_t>(index),
       .rule = index,
       .lamp = rule.lamp.value_or(0),
       .opacity = 1.0,
       .projector = first_projector(pinned_point(*surface_, pin->place), size_),
       .place = pin->place,
       .controls = rule.controls},
      rule);
}

void DrawnHighlights::add(const DrawnHighlight& highlight, const HighlightRule& rule) {
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

void DrawnHighlights::add_copy(const DrawnHighlight& highlight, const HighlightRule& rule) {
  const std::size_t first = faces_.size();
  regions_.find(highlight.projector, highlight.place.face, faces_);
  keep_masked(rule, first);
  highlights_.push_back(highlight);
  highlights_.back().first_face = first;
  highlights_.back().face_count = faces_.size() - first;
}

void DrawnHighlights::keep_masked(const HighlightRule& rule, std::size_t first_face) {
  if (!rule.mask_m) return;
  const TriangleMesh& mesh = surface_->mesh();
  const auto is_beyond = [&](std::uint32_t face) {
    const TriangleIndices& corners = mesh.faces[face];
    return std::none_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
      return glm::distance(mesh.positions_m[corner], *rule.mask_m) <= rule.mask_radius_m;
    });
  };
  const auto first = faces_.begin() + static_cast<std::ptrdiff_t>(first_face);
  faces_.erase(std::remove_if(first, faces_.end(), is_beyond), faces_.end());
}

}  // namespace offing::highlights
