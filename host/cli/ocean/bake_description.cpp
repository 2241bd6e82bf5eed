#include "host/cli/ocean/bake_description.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/cli/ocean/frame_maps.h"
#include "host/cli/ocean/water_left_out.h"
#include "host/ocean/query/gerstner_instant.h"
#include "host/scene/file/version.h"

namespace offing::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Infinity is null.
Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json axes_json(MapAxes axes) {
  const bool is_z_up = axes == MapAxes::z_up;
  return {{"name", is_z_up ? "z-up" : "y-up"},
          {"east", "+x"},
          {"north", is_z_up ? "+y" : "-z"},
          {"up", is_z_up ? "+z" : "+y"}};
}

Json texels_json(const scene::Sea& sea, MapAxes axes) {
  return {{"columns", sea.parameters.size},
          {"rows", sea.parameters.size},
          {"column_axis", "+x"},
          {"row_axis", axes == MapAxes::z_up ? "-y" : "+z"},
          {"first_texel_m", {0.0, 0.0}}};
}

Json values_json(const BakeSettings& settings) {
  const bool is_half = settings.pixel_type == PixelType::half_16;
  return {{"type", is_half ? "float16" : "float32"},
          {"relative_error", is_half ? half_relative_error : 0.0},
          {"absolute_error", is_half ? half_absolute_error : 0.0}};
}

Json maps_json(const BakeSettings& settings, const std::vector<BakedMap>& maps, std::size_t cascade) {
  Json json = Json::object();
  for (const BakedMap& map : maps) {
    if (map.cascade != cascade) continue;
    Json channels = Json::array();
    for (const BakedMap::Channel& channel : map.channels) channels.push_back(channel.name);
    Json& of_map = json[std::string(map.name)];
    of_map = {{"unit", map.unit.empty() ? "1" : map.unit},
              {"file", map.file + ".%04d.exr"},
              {"channels", std::move(channels)}};
    if (map.name == "velocity") of_map["depth_m"] = settings.velocity_depth_m;
  }
  return json;
}

Json cascades_json(const scene::Sea& sea, const BakeSettings& settings, const scene::EnergyShares& energy) {
  const std::vector<ocean::Cascade>& cascades = sea.parameters.cascades;
  const std::vector<BakedMap> maps = baked_maps(settings, cascades.size());
  const bool is_first_whole = settings.gerstner == GerstnerUse::included && sea.has_gerstner_waves();
  Json json = Json::array();
  for (std::size_t i = 0; i < cascades.size(); ++i) {
    json.push_back({{"patch_m", cascades[i].patch_length_m},
                    {"texel_m", cascades[i].patch_length_m / sea.parameters.size},
                    {"k_min_radpm", cascades[i].k_min_radpm},
                    {"k_max_radpm", cascades[i].k_max_radpm},
                    {"m0_m2", energy.cascade_m0_m2[i]},
                    {"tileable", i > 0 || !is_first_whole},
                    {"maps", maps_json(settings, maps, i)}});
  }
  return json;
}

Json wakes_json(const scene::Scene& scene, const scene::Sea& sea, const BakeSettings& settings) {
  const std::size_t cascades = sea.parameters.cascades.size();
  const std::vector<BakedMap> maps = baked_maps(settings, cascades);
  Json json = Json::array();
  for (std::size_t i = 0; i < settings.wake_cells.size(); ++i) {
    const double length_m = scene.ocean.wakes[i].parameters.length_m;
    json.push_back(
        {{"length_m", length_m},
         {"texel_m", length_m / settings.wake_cells[i]},
         {"columns", settings.wake_cells[i]},
         {"rows", settings.wake_cells[i]},
         {"first_texel_m", fmt::format("attributes origin_x_m and {} of each file",
                                       settings.axes == MapAxes::z_up ? "origin_y_m" : "origin_z_m")},
         {"maps", maps_json(settings, maps, cascades + i)}});
  }
  return json;
}

Json gerstner_json(const scene::Sea& sea, const BakeSettings& settings) {
  const ocean::GerstnerInstant start(sea.parameters.gerstner_waves, 0.0);
  const bool is_z_up = settings.axes == MapAxes::z_up;
  Json waves = Json::array();
  for (const ocean::GerstnerInstant::Wave& wave : start.waves()) {
    waves.push_back({{"amplitude_m", wave.amplitude_m},
                     {"kx_radpm", wave.kx_radpm},
                     {is_z_up ? "ky_radpm" : "kz_radpm", is_z_up ? -wave.kz_radpm : wave.kz_radpm},
                     {"omega_radps", wave.omega_radps},
                     {"phase_rad", wave.phase_rad}});
  }
  return {{"in_maps", settings.gerstner == GerstnerUse::included},
          {"choppiness", start.horizontal_scale()},
          {"m0_m2", energy_m2(sea.parameters.gerstner_waves.waves)},
          {"waves", std::move(waves)}};
}

Json mesh_json(MeshFormat format) {
  if (format == MeshFormat::none) return {};
  return format == MeshFormat::obj ? "ocean.%04d.obj" : "ocean.%04d.ply";
}

Json left_out_json(const scene::Scene& scene, const scene::Sea& sea, GerstnerUse use, WakeUse wakes) {
  Json json = Json::array();
  for (const auto& [part, what] : water_left_out(scene, wakes))
    json.push_back(fmt::format("{}: {}", part, what));
  if (use == GerstnerUse::included) return json;
  if (!sea.parameters.gerstner_waves.waves.empty()) json.push_back("the waves listed in gerstner");
  if (!sea.raindrops.empty()) json.push_back("[[ocean.raindrop]]");
  return json;
}

}  // namespace

double energy_m2(const std::vector<ocean::GerstnerWave>& waves) {
  return std::accumulate(waves.begin(), waves.end(), 0.0, [](double sum, const ocean::GerstnerWave& wave) {
    return sum + 0.5 * wave.amplitude_m * wave.amplitude_m;
  });
}

nlohmann::ordered_json bake_description(const scene::Scene& scene, const scene::Sea& sea,
                                        const BakeSettings& settings, const scene::EnergyShares& energy,
                                        const std::string& scene_hash) {
  const double maps_m0_m2 = std::accumulate(
      energy.cascade_m0_m2.begin(), energy.cascade_m0_m2.end(),
      settings.gerstner == GerstnerUse::included ? energy_m2(sea.parameters.gerstner_waves.waves) : 0.0);
  const std::optional<double>& loop_s = sea.parameters.loop_period_s;
  return {{"version", 1},
          {"offing_version", scene::version()},
          {"scene_hash", scene_hash},
          {"axes", axes_json(settings.axes)},
          {"units", {{"length", "m"}, {"time", "s"}, {"angle", "rad"}}},
          {"texels", texels_json(sea, settings.axes)},
          {"values", values_json(settings)},
          {"frames", {{"first", settings.frames.first}, {"last", settings.frames.last}}},
          {"frames_per_second", settings.frames_per_second},
          {"loop_period_s", loop_s ? Json(*loop_s) : Json()},
          {"spectrum", scene::spectrum_name(scene, sea)},
          {"seed", fmt::format("{}", sea.parameters.seed)},
          {"hs_m", 4.0 * std::sqrt(energy.m0_m2 + energy_m2(sea.swells))},
          {"maps_hs_m", 4.0 * std::sqrt(maps_m0_m2)},
          {"choppiness", sea.parameters.choppiness},
          {"depth_m", number_or_null(sea.spectrum.dispersion.depth_m)},
          {"cascades", cascades_json(sea, settings, energy)},
          {"mesh", mesh_json(settings.mesh)},
          {"gerstner", gerstner_json(sea, settings)},
          {"wakes", wakes_json(scene, sea, settings)},
          {"left_out", left_out_json(scene, sea, settings.gerstner,
                                     settings.wake_cells.empty() ? WakeUse::left_out : WakeUse::included)}};
}

}  // namespace offing::cli
