#pragma once

#include <optional>

#include "host/ocean/surface/mode_transform.h"
#include "host/ocean/surface/wave_modes.h"

namespace offing::ocean {

/// The water's depth as the kernels read it: finite where the water has no bed.
float finite_depth_m(double water_depth_m);

/// The kernels of VelocityMap.
ModeTransform::Request velocity_request();

/// Particle velocity and pressure of every cascade at one time and one depth below the instantaneous surface,
/// on the device.
class VelocityMap {
 public:
  VelocityMap(const ocl::Device& device, const WaveModes& modes, double water_depth_m);

  /// Enqueues the map of the modes with these amplitudes, unless it is already that of this time and depth.
  void at(const WaveModes& modes, const ocl::Buffer<float>& amplitude, double time_s,
          double depth_below_surface_m);
  /// Forgets the map: the waves have changed.
  void reset() { held_.reset(); }

  /// [cascades][n][n] float4: vx, vy, vz m/s, and the head m: the dynamic pressure over density and gravity.
  const ocl::Buffer<float>& velocity() const { return velocity_; }

 private:
  struct Place {
    double time_s, depth_below_surface_m;
    bool operator==(const Place&) const = default;
  };

  ModeTransform transform_;
  std::optional<Place> held_;  // what velocity_ belongs to
  float water_depth_m_;
  ocl::Buffer<float> velocity_;
};

}  // namespace offing::ocean
