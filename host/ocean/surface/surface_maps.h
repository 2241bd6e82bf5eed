#pragma once

#include "host/ocean/surface/mode_transform.h"
#include "host/ocean/surface/wave_modes.h"

namespace offing::ocean {

/// The kernels of SurfaceMaps.
ModeTransform::Request surface_request();

/// The surface of every cascade at one time, on the device: eight real fields in two maps.
class SurfaceMaps {
 public:
  SurfaceMaps(const ocl::Device& device, const WaveModes& modes, double choppiness);

  /// Enqueues the maps at this time.
  void at(const WaveModes& modes, double time_s) { at(modes, modes.amplitude(), time_s); }
  /// The same of the modes with these amplitudes, laid out as WaveModes has them.
  void at(const WaveModes& modes, const ocl::Buffer<float>& amplitude, double time_s) {
    at(modes, amplitude, choppiness_, time_s);
  }
  /// And with this choppiness.
  void at(const WaveModes& modes, const ocl::Buffer<float>& amplitude, double choppiness, double time_s);

  /// [cascades][n][n] float4: dx m, h m, dz m, d dx/dz.
  const ocl::Buffer<float>& displacement() const { return displacement_; }
  /// [cascades][n][n] float4: dh/dx, dh/dz, d dx/dx, d dz/dz.
  const ocl::Buffer<float>& gradient() const { return gradient_; }

 private:
  ModeTransform transform_;
  double choppiness_;
  ocl::Buffer<float> displacement_;
  ocl::Buffer<float> gradient_;
};

}  // namespace offing::ocean
