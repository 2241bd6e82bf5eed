#include "present/editing/highlight_edits.h"

#include <algorithm>
#include <string>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/scene/schema/unused_parameters.h"
#include "present/timeline/keyframe_edits.h"

namespace offing::present {
namespace {

using scene::ElementIndex;
using scene::Parameter;
using scene::Scene;

enum class Keys { existing, all };

void set_key(KeyframeTrack& track, double time_s, double value) {
  const auto place = std::lower_bound(track.keys.begin(), track.keys.end(), time_s - same_time_s,
                                      [](const Keyframe& key, double time) { return key.time_s < time; });
  if (place != track.keys.end() && place->time_s <= time_s + same_time_s) {
    place->value = value;
  } else {
    track.keys.insert(place, {time_s, value});
  }
}

/// The name of a light, as rules have it. One that has none gets one: a rule without a name is for all
/// lights.
std::string name_of_light(Scene& scene, int light) {
  const auto index = static_cast<std::size_t>(light);
  if (index >= scene.lights.size()) return "sun";
  std::string& name = scene.lights[index].name;
  for (std::size_t number = index + 1; name.empty(); ++number) {
    const std::string free = "light " + std::to_string(number);
    if (std::ranges::find(scene.lights, free, &scene::LightScene::name) == scene.lights.end()) name = free;
  }
  return name;
}

/// The constant of a value that moves is that of its first key, as the reader of scenes has it.
void store_tracks(Scene& scene, ElementIndex element, double time_s, Keys keys) {
  for (const Parameter& row : scene::parameter_table()) {
    if (row.group != scene::ParameterGroup::highlight || row.motion == scene::ParameterMotion::constant)
      continue;
    const std::vector<double*> numbers = scene::numbers_of(scene, row, element);
    const bool moves = scene.tracks.contains({row.key, element});
    const bool is_wanted =
        keys == Keys::all && scene::reason_unused(row, {.scene = scene, .element = element}).empty();
    if (!moves && !is_wanted) continue;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      KeyframeTrack& track = scene.tracks[{row.key, element, i}];
      set_key(track, time_s, *numbers[i]);
      *numbers[i] = track.keys.front().value;
    }
  }
}

void store(Scene& scene, ElementIndex element, const highlights::HighlightControls& controls, double time_s,
           Keys keys) {
  highlights::HighlightControls& stored = scene.meshes[element.outer].highlights[element.inner].rule.controls;
  const int picture = stored.picture;  // which the scene knows by its name
  stored = controls;
  stored.picture = picture;
  store_tracks(scene, element, time_s, keys);
}

}  // namespace

ElementIndex controls_of(Scene& scene, const HighlightName& name,
                         const highlights::DrawnHighlight& highlight) {
  std::vector<scene::HighlightScene>& all = scene.meshes[name.mesh].highlights;
  if (highlight.rule >= 0) return {name.mesh, static_cast<std::size_t>(highlight.rule)};
  scene::HighlightScene own;
  own.rule.nearest_m = highlight.found_at_rest_m;
  own.light = name_of_light(scene, highlight.light);
  own.rule.controls = highlight.controls;
  all.push_back(std::move(own));
  return {name.mesh, all.size() - 1};
}

void store_controls(Scene& scene, ElementIndex element, const highlights::HighlightControls& controls,
                    double time_s) {
  store(scene, element, controls, time_s, Keys::existing);
}

void store_keys(Scene& scene, ElementIndex element, const highlights::HighlightControls& controls,
                double time_s) {
  store(scene, element, controls, time_s, Keys::all);
}

const highlights::DrawnHighlight* picked_highlight(const Scene& scene,
                                                   const std::vector<world::WorldMesh>& meshes,
                                                   const std::optional<HighlightName>& picked) {
  return picked && picked->mesh < scene.meshes.size() ? find_highlight(meshes, *picked) : nullptr;
}

bool has_keys(const Scene& scene, ElementIndex element) {
  return std::any_of(scene.tracks.begin(), scene.tracks.end(), [&](const auto& track) {
    return scene::find_parameter(track.first.key)->group == scene::ParameterGroup::highlight &&
           track.first.element == element;
  });
}

void remove_keys(Scene& scene, ElementIndex element, const highlights::HighlightControls& controls) {
  std::erase_if(scene.tracks, [&](const auto& track) {
    const Parameter& row = *scene::find_parameter(track.first.key);
    return row.group == scene::ParameterGroup::highlight && track.first.element == element;
  });
  store(scene, element, controls, 0.0, Keys::existing);
}

}  // namespace offing::present
