#include "host/scene/schema/unused_parameters.h"

#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/world/cloud_light.h"

namespace offing::scene {

namespace {

SeaFacts facts_of(const Sea& sea) {
  SeaFacts facts{.is_there = true, .is_deep = std::isinf(sea.spectrum.dispersion.depth_m)};
  if (sea.measured) {
    facts.is_measured = true;
    facts.is_directional = sea.measured->is_directional();
    facts.last_hz = sea.measured->frequencies_hz.back();
  }
  return facts;
}

/// A line for each [[light]] of a scene with clouds that does not light them, with its place and the reason.
std::vector<std::string> lights_without_clouds(const Scene& scene) {
  std::vector<std::string> lines;
  if (!scene.has_clouds()) return lines;
  const bool has_sun_alone = scene.cloud_settings.light == clouds::LightModel::harris;
  const std::size_t taken = has_sun_alone ? 0 : world::most_lights_on_clouds;
  const std::string reason = has_sun_alone ? "clouds.light is harris, which uses only the sun"
                                           : fmt::format("clouds use only the first {} lights", taken);
  std::set<std::size_t> known;  // a line for each light
  for (const auto& [key, place] : scene.set_at) {
    const Parameter* row = find_parameter(key.key);
    if (row == nullptr || row->group != ParameterGroup::light || key.element.outer < taken) continue;
    if (known.insert(key.element.outer).second)
      lines.push_back(fmt::format("{}: does not light the clouds: {}", place, reason));
  }
  return lines;
}

std::vector<std::string> unused_lines(const Scene& scene, const SeaFacts& sea) {
  std::vector<std::string> lines;
  for (const Parameter& row : parameter_table()) {
    for (const ElementIndex element : elements_of(scene, *row.section)) {
      const auto place = scene.set_at.find({row.key, element});
      if (place == scene.set_at.end()) continue;
      const std::string reason = reason_unused(row, {.scene = scene, .element = element, .sea = sea});
      if (!reason.empty()) lines.push_back(fmt::format("{}: not used: {}", place->second, reason));
    }
  }
  for (std::string& line : lights_without_clouds(scene)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

std::string reason_unused(const Parameter& row, const UseContext& context) {
  if (!context.sea.is_there && share_a_bit(row.affects, parts_of_sea)) return "the scene has no [ocean]";
  return row.unused ? row.unused(context, struct_at(&context.scene, *row.section, context.element)) : "";
}

std::vector<std::string> unused_parameters(const Scene& scene, const Sea& sea) {
  return unused_lines(scene, facts_of(sea));
}

std::vector<std::string> unused_parameters(const Scene& scene) {
  return unused_lines(scene, {});
}

std::vector<std::string> unused_cloud_parameters(const Scene& scene) {
  std::vector<std::string> lines;
  for (const auto& [key, place] : scene.set_at) {
    const Parameter* row = find_parameter(key.key);
    if (row == nullptr || !share_a_bit(row->affects, Affects::clouds)) continue;
    const std::string reason = reason_unused(*row, {.scene = scene, .element = key.element});
    if (!reason.empty()) lines.push_back(fmt::format("{}: not used: {}", place, reason));
  }
  return lines;
}

}  // namespace offing::scene
