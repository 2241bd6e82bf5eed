#include "host/ocean/query/query_waves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernels/shared/query_params.h"

namespace offing::ocean {
namespace {

ModeFields::Place place_of(double time_s, const WaterQuery& query) {
  const bool has_flow = query.fields == WaterQuery::Fields::surface_and_flow;
  return {.time_s = time_s,
          .min_wavelength_m = query.min_wavelength_m,
          .depth_m = has_flow ? std::optional(query.depth_m) : std::nullopt};
}

}  // namespace

int QueryWaves::map_size(const WaterQuery& query) const {
  double most_cycles = 0.0;
  for (const Cascade& cascade : cascades_)
    most_cycles = std::max(most_cycles, mode_radius(cascade, query.min_wavelength_m));
  return query_map_size(most_cycles);
}

QueryWaves::Source QueryWaves::at(const WaveModes& modes, double time_s, const WaterQuery& query,
                                  Accuracy accuracy) {
  if (!fields_) fields_.emplace(device_, modes, choppiness_, dispersion_.depth_m);
  const ModeFields::Place place = place_of(time_s, query);
  if (accuracy == Accuracy::exact) {
    fields_->at(modes, place);
    return ModeSums{.fields = fields_->fields(), .columns = modes.columns()};
  }
  const int size = map_size(query), map_fields = place.depth_m ? QUERY_MAP_FIELDS : QUERY_SURFACE_FIELDS;
  QueryMaps& maps =
      maps_.try_emplace({size, map_fields}, device_, modes, cascades_, size, map_fields).first->second;
  maps.at(modes, *fields_, place, {.choppiness = choppiness_, .dispersion = dispersion_});
  return SplineMaps{.map = maps.map(), .map_fields = map_fields, .scales = maps.scales()};
}

int QueryWaves::size(const WaveModes& modes, const WaterQuery& query, Accuracy accuracy) const {
  return accuracy == Accuracy::maps ? map_size(query) : modes.size();
}

double QueryWaves::error_rms_m(const WaveModes& modes, const GerstnerSea& gerstner_waves,
                               const WaterQuery& query, Accuracy accuracy) {
  const auto [entry, is_new] = errors_.try_emplace({accuracy, query.min_wavelength_m});
  if (is_new) {
    const int cycles = modes.size() / 2;
    const AxisResponse response =
        accuracy == Accuracy::maps
            ? spline_response(QUERY_TAPS, map_size(query), cycles)
            : (accuracy == Accuracy::exact ? exact_response(cycles) : linear_response(modes.size(), cycles));
    for (std::size_t i = 0; i < cascades_.size(); ++i) {
      if (mode_radius(cascades_[i], query.min_wavelength_m) == 0.0) continue;
      entry->second +=
          cascade_error(cascades_[i], modes.variance(static_cast<int>(i)), modes.size(), choppiness_,
                        query.min_wavelength_m, response, accuracy == Accuracy::frame_maps);
    }
  }
  LabelError error = entry->second;
  error += gerstner_error(gerstner_waves, query.min_wavelength_m);
  return error.height_rms_m();
}

void QueryWaves::reset() {
  if (fields_) fields_->reset();
  for (auto& [kind, maps] : maps_) maps.reset();
}

}  // namespace offing::ocean
