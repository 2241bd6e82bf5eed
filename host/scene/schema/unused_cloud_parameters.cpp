#include "host/scene/schema/unused_cloud_parameters.h"

#include <cstddef>
#include <set>

#include <fmt/format.h>

#include "host/clouds/shape/genera.h"
#include "host/scene/schema/parameter_table.h"
#include "host/world/cloud_light.h"

namespace offing::scene {

namespace {

/// The key of what makes a cloud in place of its balls; empty where they do.
std::string shape_key(const CloudShapeScene& shape) {
  if (!shape.file.empty()) return "cloud.file";
  if (!shape.mesh.empty()) return "cloud.mesh";
  if (!shape.text.empty()) return "cloud.text";
  return shape.is_given() ? "cloud.shape" : "";
}

bool grows(const CloudScene& cloud) {
  if (cloud.modelling != CloudModelling::as_genus) return cloud.modelling == CloudModelling::hierarchical;
  return clouds::preset(cloud.genus).modelling == clouds::Modelling::hierarchical;
}

}  // namespace

bool is_of_one_cloud(const Parameter& row) {
  using enum ParameterGroup;
  return row.group == cloud || row.group == cloud_ball || row.group == cloud_level;
}

std::string against_cloud(const CloudScene& cloud, ParameterUse use) {
  const CloudShapeScene& shape = cloud.shape;
  const std::string made_by = shape_key(shape);
  switch (use) {
    case ParameterUse::balled_cloud:
      return made_by.empty() ? "" : made_by + " makes it";
    case ParameterUse::sampled_cloud:
      if (made_by.empty()) return grows(cloud) ? "it grows on its balls" : "";
      return shape.file.ends_with(".ply") ? "cloud.file has its particles" : "";
    case ParameterUse::grown_cloud:
      if (!made_by.empty()) return made_by + " makes it";
      return grows(cloud) ? "" : "it is sampled";
    case ParameterUse::filed_cloud:
      return shape.file.empty() ? "cloud.file is not given" : "";
    case ParameterUse::shaped_cloud:
      return shape.mesh.empty() && shape.text.empty() && shape.solid == 0
                 ? "none of cloud.mesh, cloud.text and cloud.shape is given"
                 : "";
    case ParameterUse::turned_cloud:
      return made_by.empty() ? "none of cloud.file, cloud.mesh, cloud.text and cloud.shape is given" : "";
    case ParameterUse::text_cloud:
      return shape.text.empty() ? "cloud.text is not given" : "";
    case ParameterUse::heated_cloud:
      return cloud.motion.heat_k ? "" : "cloud.heat_k is not given";
    case ParameterUse::obstructed_cloud:
      return cloud.motion.obstacle_m ? "" : "cloud.obstacle_m is not given";
    default:
      return "";
  }
}

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

std::vector<std::string> unused_cloud_parameters(const Scene& scene) {
  std::vector<std::string> lines;
  for (const auto& [key, place] : scene.set_at) {
    const Parameter* row = find_parameter(key.key);
    if (row == nullptr || !is_of_one_cloud(*row)) continue;
    const std::string reason = against_cloud(scene.clouds[key.element.outer], row->use);
    if (!reason.empty()) lines.push_back(fmt::format("{}: not used: {}", place, reason));
  }
  return lines;
}

}  // namespace offing::scene
