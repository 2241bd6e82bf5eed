#include "present/editing/objects/pushed_value.h"

#include <algorithm>

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

}  // namespace offing::present
