#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>

#include "host/ocean/query/mode_fields.h"
#include "host/ocean/query/query_error.h"
#include "host/ocean/query/query_maps.h"
#include "host/ocean/query/surface_query.h"
#include "host/ocean/query/water_query.h"

namespace offing::ocean {

/// What queries need of the waves of a sea's cascades besides a frame's maps, made at first use, and the
/// errors that they are expected to have.
class QueryWaves {
 public:
  QueryWaves(const ocl::Device& device, std::span<const Cascade> cascades, double choppiness,
             const Dispersion& dispersion)
      : device_(device), cascades_(cascades), choppiness_(choppiness), dispersion_(dispersion) {}

  using Accuracy = WaterQuery::Accuracy;
  using Source = std::variant<FrameMaps, SplineMaps, ModeSums>;

  /// Enqueues what a query of this accuracy, exact or maps, reads at a time, unless it is there already.
  Source at(const WaveModes& modes, double time_s, const WaterQuery& query, Accuracy accuracy);
  /// Samples along a side, or rows of the modes.
  int size(const WaveModes& modes, const WaterQuery& query, Accuracy accuracy) const;
  /// Expected error of heights at points, m.
  double error_rms_m(const WaveModes& modes, const GerstnerSea& gerstner_waves, const WaterQuery& query,
                     Accuracy accuracy);
  /// Forgets fields and maps: the waves have changed. Their spectrum has not.
  void reset();

 private:
  int map_size(const WaterQuery& query) const;

  ocl::Device device_;
  std::span<const Cascade> cascades_;
  double choppiness_;
  Dispersion dispersion_;
  std::optional<ModeFields> fields_;
  // By size and fields: hulls ask for long waves alone, which take smaller ones.
  std::map<std::pair<int, int>, QueryMaps> maps_;
  std::map<std::pair<Accuracy, double>, LabelError> errors_;  // by accuracy and minimum wavelength
};

}  // namespace offing::ocean
