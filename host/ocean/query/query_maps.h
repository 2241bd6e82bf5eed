#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "host/ocean/query/mode_fields.h"
#include "host/ocean/surface/mode_transform.h"
#include "host/ocl/buffer.h"
#include "kernels/shared/query_params.h"

namespace offing::ocean {

/// The kernels of QueryMaps: of maps with all fields, or of the surface alone; for modes of this many rows.
ModeTransform::Request query_map_request(int map_fields, int mode_rows);

/// Samples along a side of maps for waves up to this many cycles along it: four samples for the shortest
/// wave, as far as transforms go.
int query_map_size(double most_cycles);

/// A cascade's variance over the number of cycles of its waves along a side, as far as the scales of a map
/// need it: by [cycles], rounded, of heights as they are filtered for a map. m^2.
struct FilteredVariance {
  std::vector<double> heights_m2;
  std::vector<double> along_x_m2, along_z_m2;  ///< times (kx / k)^2 and (kz / k)^2
};

/// Maps of all cascades made for queries, at one time on the device: finer than those of a frame, and
/// filtered so that ocean/spline_cells.clh, which reads them, gives waves back as they are. This is a
/// nonuniform Fourier transform of type 2 (Barnett, Magland & af Klinteberg 2019) whose kernel is a B-spline.
/// Texels are 16-bit fractions of eight standard deviations: half the memory that floats take is half the
/// time of scattered points.
class QueryMaps {
 public:
  /// `size`: n, samples along a side; `map_fields`: QUERY_MAP_FIELDS or QUERY_SURFACE_FIELDS.
  QueryMaps(const ocl::Device& device, const WaveModes& modes, std::span<const Cascade> cascades, int size,
            int map_fields);

  /// What is asked besides the place: the sea's.
  struct Sea {
    double choppiness;
    Dispersion dispersion;
  };

  /// Enqueues the maps, unless they are there already; asks `fields` for what they are made from.
  void at(const WaveModes& modes, ModeFields& fields, const ModeFields::Place& place, const Sea& sea);
  /// Forgets them: the waves have changed. Their spectrum has not.
  void reset() { held_.reset(); }

  /// [cascades][n][n + QUERY_MAP_HALO][map fields] shorts, two to a float (ocean/query_map_rows.cl).
  const ocl::Buffer<float>& map() const { return map_; }
  /// [cascades][QUERY_MAP_FIELDS]: what a short of a field is worth.
  std::span<const float> scales() const { return scales_; }

 private:
  void set_scales(const WaveModes& modes, const ModeFields::Place& place, const Sea& sea);

  std::span<const Cascade> cascades_;
  ModeTransform transform_;
  std::vector<FilteredVariance> variances_;  // of each cascade
  std::optional<ModeFields::Place> held_, scaled_;
  std::vector<float> scales_;
  ocl::Buffer<float> filter_, inverse_scales_, map_;
};

}  // namespace offing::ocean
