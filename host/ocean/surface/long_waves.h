#pragma once

#include <optional>

#include "host/ocean/surface/surface_maps.h"
#include "host/ocean/surface/velocity_map.h"
#include "host/ocean/surface/wave_modes.h"

namespace offing::ocean {

/// The maps of a sea without its short waves: each mode counts in full or, if it is shorter than asked, not
/// at all.
class LongWaves {
 public:
  LongWaves(const ocl::Device& device, const WaveModes& modes, double choppiness, double water_depth_m);

  /// Enqueues the surface of the waves no shorter than this, unless it is there already.
  void at(const WaveModes& modes, double min_wavelength_m, double time_s);
  /// Enqueues their velocity at the time of at(), unless it is there already.
  void velocity_at(const WaveModes& modes, double depth_below_surface_m);
  /// Forgets all: the waves have changed.
  void reset();

  const SurfaceMaps& surface() const { return surface_; }
  const ocl::Buffer<float>& velocity() const { return velocity_->velocity(); }

 private:
  ocl::Device device_;
  double water_depth_m_;
  ocl::Kernel filter_;
  ocl::Buffer<float> amplitude_;
  std::optional<double> min_wavelength_m_;  // of amplitude_
  SurfaceMaps surface_;
  std::optional<double> time_s_;  // of surface_
  std::optional<VelocityMap> velocity_;
};

}  // namespace offing::ocean
