#include "present/timeline/keyframe_edits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/scene/schema/parameter_table.h"
#include "present/panels/parameter_widget.h"

namespace offing::present {
namespace {

bool is_at(const Keyframe& key, double time_s) {
  return std::abs(key.time_s - time_s) <= same_time_s;
}

}  // namespace

std::vector<double> key_times(const Tracks& tracks) {
  std::vector<double> times;
  for (const auto& [value, track] : tracks) {
    for (const Keyframe& key : track.keys) times.push_back(key.time_s);
  }
  std::ranges::sort(times);
  const auto same = [](double one, double other) { return other - one <= same_time_s; };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
  return times;
}

std::optional<double> key_after(const Tracks& tracks, double time_s) {
  const std::vector<double> times = key_times(tracks);
  const auto next = std::ranges::upper_bound(times, time_s + same_time_s);
  return next == times.end() ? std::nullopt : std::optional(*next);
}

std::optional<double> key_before(const Tracks& tracks, double time_s) {
  const std::vector<double> times = key_times(tracks);
  const auto next = std::ranges::lower_bound(times, time_s - same_time_s);
  return next == times.begin() ? std::nullopt : std::optional(*std::prev(next));
}

std::string values_with_keys(const Tracks& tracks, double time_s) {
  std::vector<std::string> names;
  for (const auto& [value, track] : tracks) {
    if (value.number > 0 ||
        std::ranges::none_of(track.keys, [&](const Keyframe& key) { return is_at(key, time_s); }))
      continue;
    const scene::Parameter& row = *scene::find_parameter(value.key);
    names.push_back(fmt::format("{} {}", scene::name_of(scene::section_of(row.key)), words_of(row)));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

Tracks with_moved_keys(const Tracks& tracks, double from_s, double to_s, double frame_s) {
  double low_s = -std::numeric_limits<double>::infinity(), high_s = -low_s;
  for (const auto& [value, track] : tracks) {
    for (std::size_t i = 0; i < track.keys.size(); ++i) {
      if (!is_at(track.keys[i], from_s)) continue;
      if (i > 0) low_s = std::max(low_s, track.keys[i - 1].time_s + frame_s);
      if (i + 1 < track.keys.size()) high_s = std::min(high_s, track.keys[i + 1].time_s - frame_s);
    }
  }
  if (low_s > high_s) return tracks;  // there is no room
  Tracks moved = tracks;
  for (auto& [value, track] : moved) {
    for (Keyframe& key : track.keys) {
      if (is_at(key, from_s)) key.time_s = std::clamp(to_s, low_s, high_s);
    }
  }
  return moved;
}

}  // namespace offing::present
