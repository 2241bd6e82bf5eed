#include "host/scene/schema/unused_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "host/io/tile_store/tile_store.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/scene/schema/unused_cloud_parameters.h"
#include "host/scene/schema/unused_mesh_parameters.h"

namespace offing::scene {

namespace {

using ocean::SpectrumModel;
using ocean::SpreadingModel;

/// Why a use of parameters has no part in a sea; empty where it has.
class Reasons {
 public:
  /// `sea` is nullptr without one.
  Reasons(const Scene& scene, const Sea* sea)
      : scene_(scene),
        has_sea_(sea != nullptr),
        is_measured_(has_sea_ && sea->measured.has_value()),
        is_directional_(is_measured_ && sea->measured->is_directional()),
        is_deep_(has_sea_ && std::isinf(sea->spectrum.dispersion.depth_m)),
        last_hz_(is_measured_ ? sea->measured->frequencies_hz.back() : 0.0) {}

  std::string against(const Parameter& row, ElementIndex element) const {
    if (row.group == ParameterGroup::light) return against_light(scene_.lights[element.outer], row.use);
    if (row.group == ParameterGroup::mesh) return against_mesh(scene_, element, row.use);
    if (row.group == ParameterGroup::body) return against_body(scene_.bodies[element.outer], row.use);
    if (is_of_one_cloud(row)) return against_cloud(scene_.clouds[element.outer], row.use);
    if (row.group == ParameterGroup::highlight) return against_highlight(scene_, element, row.use);
    return !has_sea_ && is_of_sea(row) ? "the scene has no [ocean]" : against(row.use);
  }

 private:
  static bool is_of_sea(const Parameter& row) {
    using enum ParameterGroup;
    constexpr std::array groups{wind, sea, grid, swell, raindrop, wake, wake_hull, foam};
    constexpr std::array<std::string_view, 2> keys{"world.seed", "time.loop_period_s"};
    return std::find(groups.begin(), groups.end(), row.group) != groups.end() ||
           std::find(keys.begin(), keys.end(), row.key) != keys.end();
  }

  std::string against(ParameterUse use) const {
    switch (use) {
      case ParameterUse::always:
        return "";
      case ParameterUse::modelled_sea:
        return is_measured_ ? "the sea is that of " + scene_.spectrum_file : "";
      case ParameterUse::measured_sea:
        return is_measured_ ? "" : "there is no measured spectrum";
      case ParameterUse::measured_tail:
        return against_tail();
      case ParameterUse::jonswap_or_tma:
        return unless({SpectrumModel::jonswap, SpectrumModel::tma});
      case ParameterUse::tma_depth_factor:
        return !is_measured_ && scene_.spectrum.model == SpectrumModel::tma && is_deep_
                   ? "the water is deep"
                   : unless({SpectrumModel::tma});
      case ParameterUse::phillips:
        return unless({SpectrumModel::phillips});
      case ParameterUse::swell:
        return unless({SpectrumModel::swell});
      case ParameterUse::wind:
        return is_measured_ ? "a measured sea takes no wind but its own, ocean.wind_speed_mps"
                            : against_own_wind();
      case ParameterUse::own_wind:
        return against_own_wind();
      case ParameterUse::wind_direction:
        return against_directions();
      case ParameterUse::spreading:
        return against_spreading();
      case ParameterUse::spreading_exponent:
        return against_exponent();
      case ParameterUse::chosen_cascades:
        return scene_.patch_lengths_m.empty() ? "" : "the patches are given";
      case ParameterUse::gerstner:
        return scene_.gerstner_count > 0 ? "" : "there are no Gerstner waves";
      case ParameterUse::dated_sun:
        return scene_.view.sun_time_utc ? "" : "sun.time_utc is not given";
      case ParameterUse::terrain_file:
        return scene_.terrain.file.empty() ? "terrain.file is not given, the ground is made"
                                           : against(ParameterUse::whole_map);
      case ParameterUse::tile_store:
        return is_tile_store(scene_.terrain.file) ? "" : "terrain.file is no tile store";
      case ParameterUse::whole_map:
        return is_tile_store(scene_.terrain.file) ? "the ground is that of a tile store" : "";
      case ParameterUse::made_terrain:
        return scene_.terrain.file.empty() ? "" : "the ground is that of " + scene_.terrain.file;
      case ParameterUse::dry_scene:
        return has_sea_ ? "the scene has a sea" : "";
      case ParameterUse::sea_over_terrain:
        return scene_.terrain.is_given ? "" : "the scene has no ground";
      default:  // of elements
        return "";
    }
  }

  std::string spectrum_is() const {
    return "the spectrum is " + value_text(scene_, *find_parameter("ocean.spectrum"));
  }

  std::string spreading_is() const {
    return "the spreading is " + value_text(scene_, *find_parameter("ocean.spreading"));
  }

  std::string unless(std::initializer_list<SpectrumModel> models) const {
    if (is_measured_) {
      return against(ParameterUse::modelled_sea);
    }
    return std::find(models.begin(), models.end(), scene_.spectrum.model) == models.end() ? spectrum_is()
                                                                                          : "";
  }

  std::string against_tail() const {
    // With its tail, the record ends there.
    const bool is_needless = is_measured_ && last_hz_ > *scene_.tail_hz * (1.0 + 1e-9);
    return is_needless ? fmt::format("{} reaches {:g} Hz by itself", scene_.spectrum_file, last_hz_)
                       : against(ParameterUse::measured_sea);
  }

  std::string against_directions() const {
    return is_directional_ ? scene_.spectrum_file + " has directions of its own" : "";
  }

  std::string against_spreading() const {
    const SpectrumModel model = scene_.spectrum.model;
    const bool is_fixed = model == SpectrumModel::phillips || model == SpectrumModel::swell;
    return !is_measured_ && is_fixed ? spectrum_is() + ", which has a spreading of its own"
                                     : against_directions();
  }

  std::string against_exponent() const {
    const std::string reason = against_spreading();
    const bool is_cosine = scene_.spectrum.spreading.model == SpreadingModel::cosine_2s;
    return reason.empty() && !is_cosine ? spreading_is() : reason;
  }

  std::string against_own_wind() const {
    if (!is_measured_) {
      return scene_.spectrum.model == SpectrumModel::swell ? spectrum_is() : "";
    }
    const SpreadingModel model = scene_.spectrum.spreading.model;
    const bool has_wave_age = model == SpreadingModel::mitsuyasu || model == SpreadingModel::hasselmann;
    const std::string reason = against_directions();
    return reason.empty() && !has_wave_age ? spreading_is() : reason;
  }

  const Scene& scene_;
  bool has_sea_;
  bool is_measured_;
  bool is_directional_;
  bool is_deep_;
  double last_hz_;
};

std::vector<std::string> unused_lines(const Scene& scene, const Reasons& reasons) {
  std::vector<std::string> lines;
  for (const Parameter& row : parameter_table()) {
    for (const ElementIndex element : elements_of(scene, row.elements)) {
      const auto place = scene.set_at.find({row.key, element});
      if (place == scene.set_at.end()) continue;
      const std::string reason = reasons.against(row, element);
      if (!reason.empty()) lines.push_back(fmt::format("{}: not used: {}", place->second, reason));
    }
  }
  for (std::string& line : lights_without_clouds(scene)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

std::vector<std::string> unused_parameters(const Scene& scene, const Sea& sea) {
  return unused_lines(scene, Reasons(scene, &sea));
}

std::vector<std::string> unused_parameters(const Scene& scene) {
  return unused_lines(scene, Reasons(scene, nullptr));
}

}  // namespace offing::scene
