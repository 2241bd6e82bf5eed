#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "host/highlights/search/highlight_points.h"
#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/search/lighting.h"
#include "host/highlights/tracks/highlight_track.h"
#include "host/highlights/tracks/light_shadow.h"

namespace offing::highlights {

/// Eye and lights in the mesh's axes at a time; the same for the same time. It is asked before each search
/// and wherever tracks go back, and may deform the surface to what that is at this time: highlights go along.
using LightingAt = std::function<Lighting(double time_s)>;

/// Whether tracks keep states to go back to. Those of a lighting that is not known again, such as that of an
/// eye somebody moves, never go back.
enum class KeyStates { kept, none };

/// The highlights of a surface through time, in fixed steps from a start: what is shown at a time depends on
/// the start and on the lighting only, not on the frames that were asked for. Frames need not be steps:
/// shown_at() interpolates. Key states are kept, so that going back costs at most their distance.
class HighlightTracker {
 public:
  /// The surface must outlive the tracks. Starts at time 0. Throws Error(bad_input) for options out of range.
  HighlightTracker(const HighlightSurface& surface, LightingAt lighting, const TrackOptions& options = {});

  /// Starts anew: one highlight for each point at this time, as opaque as it is lit. Without key states,
  /// going back begins at the start. Throws Error(bad_input) for a time beyond 1e8 s.
  void reset(double start_s, KeyStates keys = KeyStates::kept);
  /// Goes to the last step that is not after this time, forward or back. Throws Error(bad_input) for a time
  /// before the start or beyond 1e8 s.
  void advance_to(double time_s);
  /// Goes there as advance_to() does, and returns what is shown at exactly this time: between its last step
  /// and the next one, for which the lighting is asked too. The surface is that of this time. Valid until the
  /// next call.
  const TrackState& shown_at(double time_s);
  /// What rules for the nearest highlight go by (nearest_places()). Shares of places that are new are there
  /// at once, and the others stay as they are: steps that were taken count for them.
  void set_places(const std::vector<NearestPlace>& places);
  /// Starts from a state of this surface and lighting and of the same start, such as one that was stored.
  /// Throws Error(bad_input) for one that cannot be: a face that the surface does not have, a time out of
  /// range, ids that do not ascend, shares that are not those of its places.
  void restore(const TrackState& state);

  double time_s() const;
  const TrackState& state() const { return state_; }      ///< of the last step
  std::size_t key_count() const { return keys_.size(); }  ///< states that are kept
  const std::vector<HighlightTrack>& tracks() const { return state_.tracks; }
  const TrackOptions& options() const { return options_; }

 private:
  double time_of(std::int64_t step) const;
  /// Makes lights and surface those of a time.
  Lighting light_at(double time_s);
  /// Makes lights, surface and shadows those of a step.
  void light_up(std::int64_t step);
  void step_to(double time_s);
  /// Makes the surface that of the last step.
  void settle();
  double lit_share(const HighlightTrack& track) const;
  void step_on(TrackState& state);
  void go_back_to(const TrackState& state);
  void keep_if_key();

  const HighlightSurface* surface_;
  LightingAt lighting_;
  TrackOptions options_;
  HighlightFinder search_;
  double lit_at_s_ = 0.0;              // the time that the surface is of
  Lighting lit_by_;                    // of the last light_up()
  std::optional<LightShadow> shadow_;  // of the surface as it was then; none: not asked for
  double start_s_ = 0.0;
  TrackState state_;
  std::optional<TrackState> next_;  // the step after, where it is known
  TrackState shown_;                // of shown_at(), where that is between steps
  std::vector<NearestPlace> places_;
  KeyStates key_states_ = KeyStates::kept;
  std::int64_t key_spacing_ = 1;  // steps
  std::vector<TrackState> keys_;  // ascending steps, the first is that of the start
};

}  // namespace offing::highlights
