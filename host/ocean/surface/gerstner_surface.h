#pragma once

#include <cstdint>
#include <vector>

#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/sample_grid.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/gerstner_params.h"

/// The surface of Gerstner waves on a grid, by a device.
namespace offing::ocean {

/// Gerstner waves on a SampleGrid in host memory, each [rows][columns] row-major, row = z, column = x.
struct GerstnerFields {
  int columns = 0, rows = 0;
  std::vector<float> displacement_x, displacement_y, displacement_z;  ///< m
  std::vector<float> slope_x, slope_z;                                ///< dh/dx, dh/dz at rest labels
  std::vector<float> gradient_xx, gradient_xz, gradient_zz;           ///< d dx/dx, d dx/dz, d dz/dz
};

/// Waves as ocean/gerstner_surface.cl reads them (kernels/shared/gerstner_params.h), at time 0.
struct PackedWaves {
  std::vector<std::uint32_t> turns;  ///< [GERSTNER_TURNS][pitch]
  std::vector<float> amplitudes;     ///< [GERSTNER_FIELDS][pitch]
  int count = 0, pitch = 0;
  bool operator==(const PackedWaves&) const = default;
};

/// How much of a wave is drawn on a grid that samples it this often: nothing up to 2 samples a wavelength,
/// all of it from 4, a smooth step between.
double shown_share(double samples_per_wavelength);

/// The surface of a sea's Gerstner waves on a device (O8 of docs/sources.md). Phases are reduced to a turn in
/// double precision at the grid's first sample and stepped exactly from there, so that a grid 100 km from
/// the origin is as smooth as one at it; frequencies and times are those of WaveClock, as the cascades' are.
/// Waves that the grid is too coarse for fade (shown_share()).
class GerstnerSurface {
 public:
  explicit GerstnerSurface(const ocl::Device& device);

  /// Enqueues the surface on this grid. Waits for the surface before where waves or grid have changed since,
  /// or rings run; otherwise time alone is passed on. Throws Error(bad_input) for a sea, grid or time (beyond
  /// 1e8 s) out of range, Error(out_of_memory) if the grid does not fit.
  void at(const GerstnerSea& sea, const SampleGrid& grid, double time_s);

  /// [rows][pitch] float4: dx m, h m, dz m, d dx/dz; the layout of SurfaceMaps but for the pitch.
  const ocl::Buffer<float>& displacement() const { return displacement_; }
  /// [rows][pitch] float4: dh/dx, dh/dz, d dx/dx, d dz/dz.
  const ocl::Buffer<float>& gradient() const { return gradient_; }
  /// Samples from row to row: `columns`, or more where a row is shorter than the device's vectors.
  int pitch() const { return pitch_; }

  GerstnerFields read() const;

 private:
  void upload(PackedWaves waves, std::vector<GerstnerRing> rings);

  ocl::Device device_;
  ocl::KernelTuning tuning_;
  ocl::Kernel kernel_;
  PackedWaves waves_;  // as they are on the device
  std::vector<GerstnerRing> rings_;
  ocl::Buffer<std::uint32_t> turns_buffer_;
  ocl::Buffer<float> amplitudes_buffer_;
  ocl::Buffer<GerstnerRing> rings_buffer_;
  int columns_ = 0, rows_ = 0, pitch_ = 0;
  ocl::Buffer<float> displacement_, gradient_;
};

}  // namespace offing::ocean
