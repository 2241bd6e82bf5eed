#pragma once

#include <vector>

#include "host/fft/fft2d.h"
#include "host/ocean/ocean.h"
#include "host/ocean/sea_spectrum.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"

namespace offing::cli {

/// What one realised sea is like, measured on its surface.
struct SurfaceMeasurement {
  ocean::SeaState state;              ///< from the energies of the waves found on the surface
  std::vector<double> cascade_m0_m2;  ///< what each cascade adds to state.m0_m2
  double skewness = 0.0;              ///< of the elevation at rest labels, all cascades together
  double kurtosis = 0.0;              ///< 3 for a Gaussian surface
  double folded_share = 0.0;          ///< share of label area with composed J <= 0
};

/// Measures a sea from its surface alone: elevation and its rate of change, not the amplitudes it was made
/// from.
class SurfaceMeter {
 public:
  /// `size` samples along a patch, as the seas to be measured have.
  SurfaceMeter(const ocl::Device& device, int size);

  /// The sea at the time of its last at(). `dispersion` is what its waves follow.
  SurfaceMeasurement measure(ocean::Ocean& sea, const ocean::Dispersion& dispersion);

 private:
  std::vector<float> travelling_energies(const ocean::SurfaceFields& surface,
                                         const std::vector<float>& rise_mps, double patch_length_m,
                                         const ocean::Dispersion& dispersion);

  fft::Fft2d forward_;
  ocl::Buffer<float> packed_;
  ocl::Buffer<float> transformed_;
};

}  // namespace offing::cli
