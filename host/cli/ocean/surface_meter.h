#pragma once

#include <vector>

#include "host/fft/fft2d.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"

namespace offing::cli {

/// What one realised sea is like, measured on its surface.
struct SurfaceMeasurement {
  ocean::SeaState state;              ///< from the energies of the waves found on the surface
  std::vector<double> cascade_m0_m2;  ///< what each cascade adds to state.m0_m2
  double cascade_mss = 0.0;           ///< what all of them add to state.mss
  double skewness = 0.0;              ///< of the elevation at rest labels, the whole surface
  double kurtosis = 0.0;              ///< 3 for a Gaussian surface
  double folded_share = 0.0;          ///< share of label area with composed J <= 0
};

/// Measures a sea from its surface alone: the cascades' elevation and its rate of change, not the amplitudes
/// they were made from. Gerstner waves are the surface that they are.
class SurfaceMeter {
 public:
  /// `size` samples along a patch, as the seas to be measured have.
  SurfaceMeter(const ocl::Device& device, int size);

  /// The sea, which stands at time 0, with these Gerstner waves, which follow the same dispersion.
  SurfaceMeasurement measure(ocean::Ocean& sea, const ocean::GerstnerSea& gerstner_waves);

 private:
  std::vector<float> travelling_energies(const ocean::SurfaceFields& surface,
                                         const std::vector<float>& rise_mps, double patch_length_m,
                                         const ocean::Dispersion& dispersion);

  fft::Fft2d forward_;
  ocl::Buffer<float> packed_;
  ocl::Buffer<float> transformed_;
};

}  // namespace offing::cli
