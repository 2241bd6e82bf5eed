#pragma once

#include <optional>

#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/wave_modes.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"

namespace offing::ocean {

/// What queries read of the modes of all cascades at one time, on the device.
class ModeFields {
 public:
  /// Of which waves, when and where.
  struct Place {
    double time_s = 0.0;
    double min_wavelength_m = 0.0;  ///< shorter waves count as 0
    std::optional<double> depth_m;  ///< of the flow below the surface; none: the surface alone

    /// Whether what was made for this place answers for that one too.
    bool covers(const Place& wanted) const {
      return time_s == wanted.time_s && min_wavelength_m == wanted.min_wavelength_m &&
             (!wanted.depth_m || depth_m == wanted.depth_m);
    }
  };

  ModeFields(const ocl::Device& device, const WaveModes& modes, double choppiness, double water_depth_m);

  /// Enqueues the fields, unless they are there already.
  void at(const WaveModes& modes, const Place& place);
  /// Forgets them: the waves have changed.
  void reset() { held_.reset(); }

  /// [cascades][8][2][columns/16][n][16], as shared/query_params.h numbers them.
  const ocl::Buffer<float>& fields() const { return fields_; }

 private:
  ocl::KernelTuning tuning_;
  ocl::Kernel kernel_;
  float choppiness_, water_depth_m_;
  std::optional<Place> held_;
  ocl::Buffer<float> fields_;
};

/// No wave of a cascade that a query counts has a larger wavenumber than this, in steps of 2 pi / L; 0 where
/// it has none. A mode carries what of its cell is in the band, so that some lie a part of a step outside.
double mode_radius(const Cascade& cascade, double min_wavelength_m);

}  // namespace offing::ocean
