#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/highlights/projectors/controlled_projector.h"
#include "host/highlights/projectors/highlight_rule.h"
#include "host/highlights/projectors/region.h"
#include "host/highlights/tracks/highlight_track.h"

namespace offing::highlights {

/// Pins have ids from here on, by their rule: beyond those of all tracks, and exact as a double.
constexpr std::uint64_t first_pin_id = std::uint64_t{1} << 52;

/// One texture to draw on a mesh.
struct DrawnHighlight {
  std::uint64_t id = 0;  ///< of the track, or first_pin_id + rule
  int rule = -1;         ///< that its controls are from, -1: none
  int copy = 0;          ///< 0 ... controls.split - 1, along right
  int light = 0;         ///< whose light it is
  double opacity = 0.0;  ///< 0 ... 1, in all: that of the controls is in it
  Projector projector;   ///< in all: offset, rotation, sizes and split are in it
  SurfacePlace place;    ///< under its middle
  Projector found = {};  ///< before any control
  /// Where its middle is on the surface at rest: what a rule for this highlight names.
  glm::dvec3 found_at_rest_m{0.0};
  Projector whole = {};  ///< before it was split
  HighlightControls controls;
  std::size_t first_face = 0, face_count = 0;  ///< of HighlightDrawing::faces()
};

/// What is drawn of a surface's highlights under an artist's rules (H6, H11 of docs/sources.md). Of rules
/// that change nothing, or none, it is the tracks that can be seen (opacity above 0), as found. All controls
/// but textures, split and the mask, which are steps by nature, act continuously; what a rule for the nearest
/// draws goes over from one highlight to another within TrackLimits. Memory is used again from frame to
/// frame.
class HighlightDrawing {
 public:
  /// The surface must outlive it. `size` is that of the tracks: pins have it too. Throws Error(bad_input) for
  /// a size out of range.
  HighlightDrawing(const HighlightSurface& surface, const HighlightSize& size);

  /// Anew: what can be seen (opacity above 0), of each track in their order, then of each pin in the order of
  /// rules. Rules for the nearest go by the state's own shares; one whose place the state does not have
  /// (HighlightTracker::set_places()) is for what is nearest now. Rules of a light beyond `light_count` count
  /// for nothing; without lights there are no pins. Throws Error(bad_input) for a control out of range, and
  /// for a pin on a surface without faces.
  void update(const TrackState& state, const std::vector<HighlightRule>& rules, int light_count);

  const std::vector<DrawnHighlight>& highlights() const { return highlights_; }
  const std::vector<std::uint32_t>& faces() const { return faces_; }
  std::span<const std::uint32_t> faces_of(const DrawnHighlight& highlight) const {
    return std::span(faces_).subspan(highlight.first_face, highlight.face_count);
  }

 private:
  /// A rule with how much of a highlight is drawn as it says; -1: as found.
  struct Look {
    int rule;
    double weight;
  };
  /// A point of a rule on the surface at rest, and the place nearest to it, with which it goes along.
  struct RulePlace {
    glm::dvec3 point_m;
    SurfacePlace nearest;
  };
  using RulePlaces = std::vector<std::optional<RulePlace>>;  // [rules], as looked up last

  void set_looks(const HighlightTrack& track, std::size_t index, const std::vector<HighlightRule>& rules);
  void add(const DrawnHighlight& highlight, const HighlightRule& rule);
  void add_copy(const DrawnHighlight& highlight, const HighlightRule& rule);
  void add_pin(const HighlightRule& rule, int index);
  void keep_masked(const HighlightRule& rule, int index, std::size_t first_face);
  const SurfacePlace& nearest_to(const glm::dvec3& point_m, int rule, RulePlaces& known) const;

  const HighlightSurface* surface_;
  HighlightSize size_;
  RegionSearch regions_;
  std::vector<DrawnHighlight> highlights_;
  std::vector<std::uint32_t> faces_;
  std::vector<Look> looks_;
  std::vector<std::vector<double>> nearest_;  // [rules][tracks], of rules for the nearest
  RulePlaces pins_, masks_;
};

}  // namespace offing::highlights
