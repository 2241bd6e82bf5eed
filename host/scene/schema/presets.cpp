#include "host/scene/schema/presets.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {
namespace {

constexpr Preset beaufort(std::string_view name, std::string_view label, std::string_view wind_mps,
                          std::string_view hs_m) {
  return {name,
          label,
          ParameterGroup::sea,
          {{{"ocean.wind_speed_mps", wind_mps},
            {"ocean.hs_m", hs_m},
            {"ocean.tp_s", ""},
            {"ocean.tz_s", ""},
            {"ocean.fetch_m", ""}}}};
}

/// A genus at the height of its own. Look and noise stay.
constexpr Preset cloud_preset(std::string_view name, std::string_view genus, std::string_view label) {
  return {name,
          label,
          ParameterGroup::cloud,
          {{{"cloud.genus", genus},
            {"cloud.y_m", ""},
            {"cloud.base_m", ""},
            {"cloud.scale", ""},
            {"cloud.modelling", ""},
            {"cloud.sampling", ""},
            {"cloud.target_particles", ""}}}};
}

/// As much of a genus as a sky of it has, over a square that some tens of clouds fill.
constexpr Preset layer_preset(std::string_view name, std::string_view genus, std::string_view label,
                              std::string_view coverage, std::string_view extent_m) {
  return {name,
          label,
          ParameterGroup::cloud_layer,
          {{{"cloud_layer.genus", genus},
            {"cloud_layer.y_m", ""},
            {"cloud_layer.coverage", coverage},
            {"cloud_layer.extent_m", extent_m}}}};
}

/// Of a ship: draught 0.058 lengths, at a speed of Froude number 0.33 and the thrust that keeps it, 0.78 N a
/// cubic metre of length (present/editing/objects/new_objects.cpp has the same).
constexpr Preset hull_preset(std::string_view name, std::string_view label, std::string_view shape,
                             std::string_view size_m, std::string_view draught_m, std::string_view speed_mps,
                             std::string_view thrust_n) {
  return {name,
          label,
          ParameterGroup::body,
          {{{"mesh.file", ""},
            {"mesh.shape", shape},
            {"mesh.size_m", size_m},
            {"mesh.scale", ""},
            {"body.draught_m", draught_m},
            {"body.mass_kg", ""},
            {"body.mass_centre_m", ""},
            {"body.hydrodynamics", ""},
            {"body.propeller_m", ""},
            {"body.rudder_m2", ""},
            {"body.speed_mps", speed_mps},
            {"body.thrust_n", thrust_n}}}};
}

/// Of a row of a preset; nothing where the scene has no hull.
std::optional<ElementIndex> element_of(const Preset& preset, const Parameter& row, const Scene& scene,
                                       ElementIndex element) {
  if (preset.group != ParameterGroup::body || row.group != ParameterGroup::mesh) return element;
  const std::string& name = scene.bodies[element.outer].mesh;
  const auto mesh =
      name.empty() ? scene.meshes.begin() : std::ranges::find(scene.meshes, name, &MeshScene::name);
  if (mesh == scene.meshes.end()) return std::nullopt;
  return ElementIndex{static_cast<std::size_t>(mesh - scene.meshes.begin()), 0};
}

}  // namespace

std::span<const Preset> presets() {
  static constexpr std::array all{
      beaufort("beaufort-1", "Beaufort 1, light air", "0.84", "0.1"),
      beaufort("beaufort-2", "Beaufort 2, light breeze", "2.4", "0.2"),
      beaufort("beaufort-3", "Beaufort 3, gentle breeze", "4.3", "0.6"),
      beaufort("beaufort-4", "Beaufort 4, moderate breeze", "6.7", "1"),
      beaufort("beaufort-5", "Beaufort 5, fresh breeze", "9.3", "2"),
      beaufort("beaufort-6", "Beaufort 6, strong breeze", "12.3", "3"),
      beaufort("beaufort-7", "Beaufort 7, near gale", "15.5", "4"),
      beaufort("beaufort-8", "Beaufort 8, gale", "18.9", "5.5"),
      beaufort("beaufort-9", "Beaufort 9, strong gale", "22.6", "7"),
      beaufort("beaufort-10", "Beaufort 10, storm", "26.4", "9"),
      beaufort("beaufort-11", "Beaufort 11, violent storm", "30.5", "11.5"),
      beaufort("beaufort-12", "Beaufort 12, hurricane", "34.8", "14"),
      cloud_preset("cloud-cirrus", "cirrus", "streaks of ice, 9 km high"),
      cloud_preset("cloud-stratus", "stratus", "a low sheet"),
      cloud_preset("cloud-cumulus", "cumulus", "a fair-weather heap"),
      cloud_preset("cloud-stratocumulus", "stratocumulus", "a low, flat heap"),
      cloud_preset("cloud-altocumulus", "altocumulus", "a small heap of middle heights"),
      cloud_preset("cloud-cumulonimbus", "cumulonimbus", "a thunderstorm with its anvil"),
      cloud_preset("cloud-lenticular", "lenticular", "a lens in the lee of mountains"),
      cloud_preset("cloud-funnel", "funnel", "a funnel below a cloud"),
      layer_preset("layer-cirrus", "cirrus", "streaks of ice over a wide sky", "0.15", "20000"),
      layer_preset("layer-stratus", "stratus", "a low sheet, nearly closed", "0.75", "11000"),
      layer_preset("layer-cumulus", "cumulus", "scattered fair-weather heaps", "0.3", "9000"),
      layer_preset("layer-stratocumulus", "stratocumulus", "low, flat heaps with gaps", "0.6", "9000"),
      layer_preset("layer-altocumulus", "altocumulus", "small heaps of middle heights", "0.3", "9000"),
      layer_preset("layer-cumulonimbus", "cumulonimbus", "single thunderstorms", "0.1", "60000"),
      layer_preset("layer-lenticular", "lenticular", "lenses here and there", "0.05", "20000"),
      layer_preset("layer-funnel", "funnel", "some funnels", "0.01", "9000"),
      hull_preset("hull-buoy", "a buoy of 1.6 m, adrift", "sphere", "0.8", "0.7", "0", "0"),
      hull_preset("hull-dinghy", "an open boat of 6 m, adrift", "boat", "6", "0.32", "0", "0"),
      hull_preset("hull-launch", "a launch of 10 m", "ship", "10", "0.58", "3.3", "780"),
      hull_preset("hull-trawler", "a trawler of 20 m", "ship", "20", "1.2", "4.6", "6200"),
      hull_preset("hull-coaster", "a coaster of 45 m", "ship", "45", "2.6", "6.9", "71000"),
      hull_preset("hull-ferry", "a ferry of 90 m", "ship", "90", "5.2", "9.8", "570000"),
      hull_preset("hull-freighter", "a freighter of 160 m", "ship", "160", "9.3", "13", "3.2e6")};
  return all;
}

const Preset& find_preset(std::string_view name, std::string_view subject) {
  std::string known;
  for (const Preset& preset : presets()) {
    if (preset.group != ParameterGroup::sea) continue;
    if (preset.name == name) return preset;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", preset.name);
  }
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected the name of a preset, got \"{}\"", subject, name),
              "presets: " + known);
}

void apply(const Preset& preset, Scene& scene, ElementIndex element) {
  for (const Preset::Value& value : preset.values) {
    if (value.key.empty()) continue;
    const Parameter& row = *find_parameter(value.key);
    const std::optional<ElementIndex> of_row = element_of(preset, row, scene, element);
    if (!of_row) continue;
    clear_value(scene, row, *of_row);
    if (value.text.empty()) continue;
    store(scene, row, read_flag_value(row, std::string(value.text)),
          {.subject = fmt::format("preset {}: {}", preset.name, value.key)}, *of_row);
  }
}

}  // namespace offing::scene
