#include "present/editing/objects/pushed_value.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::present {

double within_range(std::string_view key, double value) {
  const scene::Parameter& row = *scene::find_parameter(key);
  return std::clamp(value, row.scale * row.low, row.scale * row.high);
}

void push_value(scene::Scene& scene, std::string_view key, scene::ElementIndex element, double way) {
  const scene::Parameter& row = *scene::find_parameter(key);
  for (double* number : scene::numbers_of(scene, row, element)) *number = within_range(key, *number + way);
  const auto track = scene.tracks.find({row.key, element});
  if (track == scene.tracks.end()) return;
  for (Keyframe& at : track->second.keys) at.value = within_range(key, at.value + way);
}

void turn_value(scene::Scene& scene, std::string_view key, scene::ElementIndex element, double way_rad) {
  const scene::Parameter& row = *scene::find_parameter(key);
  constexpr double turn_rad = 2.0 * std::numbers::pi;
  for (double* number : scene::numbers_of(scene, row, element))
    *number = std::remainder(*number + way_rad, turn_rad);
  const auto track = scene.tracks.find({row.key, element});
  if (track == scene.tracks.end()) return;
  std::vector<Keyframe>& keys = track->second.keys;
  for (const double whole_rad : {0.0, -turn_rad, turn_rad}) {
    const double way = way_rad + whole_rad;
    if (std::ranges::any_of(
            keys, [&](const Keyframe& at) { return within_range(key, at.value + way) != at.value + way; }))
      continue;
    for (Keyframe& at : keys) at.value += way;
    return;
  }
  // Each by itself: between keys it goes the shorter way (keyframes.h).
  for (Keyframe& at : keys) at.value = std::remainder(at.value + way_rad, turn_rad);
}

}  // namespace offing::present
