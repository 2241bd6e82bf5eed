#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/model/scene.h"

namespace offing::present {

using Tracks = std::map<scene::ValueKey, KeyframeTrack>;

/// Keyframes this near in time are one: steps of a clock there and back do not add up to nothing.
inline constexpr double same_time_s = 1e-6;

/// Times of all keyframes of a scene, in order, each once.
std::vector<double> key_times(const Tracks& tracks);

/// The next time of keyframes after or before this one; nothing if there is none.
std::optional<double> key_after(const Tracks& tracks, double time_s);
std::optional<double> key_before(const Tracks& tracks, double time_s);

/// What has keyframes at a time, in words: "camera x, camera y".
std::string values_with_keys(const Tracks& tracks, double time_s);

/// The tracks with all keyframes of one time at another one. None passes a neighbour: they stay a frame
/// apart.
Tracks with_moved_keys(const Tracks& tracks, double from_s, double to_s, double frame_s);

}  // namespace offing::present
