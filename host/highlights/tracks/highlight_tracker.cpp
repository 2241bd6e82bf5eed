#include "host/highlights/tracks/highlight_tracker.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/highlights/tracks/nearest_place.h"
#include "host/highlights/tracks/track_step.h"
#include "host/highlights/tracks/tracks_between.h"

namespace offing::highlights {
namespace {

constexpr std::size_t most_keys = 1024;
// A time this near to a step, in steps, is that step: it differs by rounding.
constexpr double same_share = 1e-6;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::bad_input, "highlights: state: " + what, "restore a state of the same mesh");
}

void require_valid(const TrackState& state, std::size_t face_count) {
  std::optional<std::uint64_t> last_id;
  for (const HighlightTrack& track : state.tracks) {
    for (const std::uint32_t face : {track.seed_face, track.point.face}) {
      if (face >= face_count)
        refuse(fmt::format("highlight {}: expected a face below {}, found {}", track.id, face_count, face));
    }
    if (track.id >= state.next_id || (last_id && track.id <= *last_id))
      refuse(fmt::format("expected ids that ascend below {}, found {}", state.next_id, track.id));
    if (track.point.light < 0)
      refuse(fmt::format("highlight {}: expected a light, found {}", track.id, track.point.light));
    if (track.nearest.size() != state.places.size())
      refuse(fmt::format("highlight {}: expected shares of {} places, found {}", track.id,
                         state.places.size(), track.nearest.size()));
    last_id = track.id;
  }
}

}  // namespace

HighlightTracker::HighlightTracker(const HighlightSurface& surface, LightingAt lighting,
                                   const TrackOptions& options)
    : surface_(&surface), lighting_(std::move(lighting)), options_(options), search_(surface.device()) {
  require_valid(options_);
  options_.size = with_cap(options_.size, surface);
  reset(0.0);
}

double HighlightTracker::time_of(std::int64_t step) const {
  return start_s_ + static_cast<double>(step) * options_.step_s;
}

double HighlightTracker::time_s() const {
  return time_of(state_.step);
}

Lighting HighlightTracker::light_at(double time_s) {
  lit_at_s_ = time_s;
  return lighting_(time_s);
}

void HighlightTracker::settle() {
  if (lit_at_s_ != time_s()) light_at(time_s());  // shown_at() has left another surface
}

void HighlightTracker::light_up(std::int64_t step) {
  lit_by_ = light_at(time_of(step));
  if (!options_.has_shadows) return;
  if (!shadow_ || shadow_->revision() != surface_->revision()) shadow_.emplace(*surface_);
}

double HighlightTracker::lit_share(const HighlightTrack& track) const {
  if (!shadow_) return 1.0;
  const auto light = static_cast<std::size_t>(track.point.light);
  // What fades after its light is gone, such as the sun, does so from where it was.
  return light < lit_by_.lights.size() ? shadow_->lit_share(track.projector, lit_by_.lights[light])
                                       : track.lit;
}

void HighlightTracker::reset(double start_s, KeyStates keys) {
  require_within("highlights.start_s", start_s, -largest_time_s, largest_time_s);
  start_s_ = start_s;
  light_up(0);
  next_.reset();
  state_ = first_state(*surface_, search_.find(*surface_, lit_by_), options_,
                       [this](const HighlightTrack& track) { return lit_share(track); });
  take_places(*surface_, places_, state_);
  keys_.assign(1, state_);
  key_states_ = keys;
  key_spacing_ = options_.key_steps;
}

void HighlightTracker::advance_to(double time_s) {
  step_to(time_s);
  settle();
}

void HighlightTracker::step_to(double time_s) {
  require_within("highlights.time_s", time_s, start_s_, largest_time_s);
  const auto wanted =
      static_cast<std::int64_t>(std::floor((time_s - start_s_) / options_.step_s + same_share));
  if (wanted < state_.step) {
    const auto after =
        std::upper_bound(keys_.begin(), keys_.end(), wanted,
                         [](std::int64_t step, const TrackState& key) { return step < key.step; });
    go_back_to(after == keys_.begin() ? keys_.front() : *std::prev(after));
  }
  if (next_ && state_.step < wanted) {
    state_ = std::move(*next_);
    next_.reset();
    keep_if_key();
  }
  while (state_.step < wanted) {
    step_on(state_);
    keep_if_key();
  }
}

const TrackState& HighlightTracker::shown_at(double time_s) {
  step_to(time_s);
  const double share = (time_s - time_of(state_.step)) / options_.step_s;
  if (share <= same_share) {
    settle();
    return state_;
  }
  if (!next_) {
    TrackState next = state_;
    step_on(next);
    next_ = std::move(next);
  }
  light_at(time_s);
  shown_ = tracks_between(*surface_, state_, *next_, share);
  return shown_;
}

void HighlightTracker::step_on(TrackState& state) {
  light_up(state.step + 1);
  advance(
      *surface_, search_.find(*surface_, lit_by_), options_, state,
      [this](const HighlightTrack& track) { return lit_share(track); }, &lit_by_);
}

void HighlightTracker::set_places(const std::vector<NearestPlace>& places) {
  places_ = places;
  if (places != state_.places) next_.reset();
  take_places(*surface_, places_, state_);
}

void HighlightTracker::restore(const TrackState& state) {
  require_valid(state, surface_->mesh().faces.size());
  if (state.step < 0) refuse(fmt::format("expected a step from 0 on, found {}", state.step));
  require_within("highlights.state.time_s", time_of(state.step), start_s_, largest_time_s);
  go_back_to(state);
}

void HighlightTracker::go_back_to(const TrackState& state) {
  state_ = state;
  next_.reset();
  light_up(state_.step);  // a surface that it deforms must not stay as it was later
  take_places(*surface_, places_, state_);
}

void HighlightTracker::keep_if_key() {
  if (key_states_ == KeyStates::none) return;
  if (state_.step % key_spacing_ != 0 || state_.step <= keys_.back().step) return;
  keys_.push_back(state_);
  if (keys_.size() <= most_keys) return;
  // A day must not fill the memory: every second one goes.
  key_spacing_ *= 2;
  std::erase_if(keys_, [&](const TrackState& key) { return key.step % key_spacing_ != 0; });
}

}  // namespace offing::highlights
