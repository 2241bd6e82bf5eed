#pragma once

#include <vector>

#include "host/base/work.h"
#include "host/ocean/spectrum/sea_statistics.h"
#include "host/ocl/device.h"
#include "host/scene/measure/energy_shares.h"
#include "host/scene/prepare/sea.h"

namespace offing::scene {

/// A figure that is measured: mean over the seeds, and its scatter.
struct Measured {
  double mean = 0.0;
  double spread = 0.0;  ///< standard deviation from seed to seed; 0 for a single seed
};

/// The sea-state certificate: what was asked of the spectrum and what the synthesised surface has.
struct Certificate {
  int seeds = 0;
  ocean::SeaState asked;                ///< of the whole spectrum, without swells beside it
  ocean::SeaState resolved;             ///< expected of the waves that the grids hold and of the swells
  ocean::SeaStateError standard_error;  ///< of the means below, expected from the mode energies
  EnergyShares energy;
  double swell_m0_m2 = 0.0;                    ///< beside the spectrum
  std::vector<double> expected_cascade_m0_m2;  ///< sums of mode energies
  std::vector<double> measured_cascade_m0_m2;  ///< means over the seeds
  Measured hs_m, peak_period_s, tp_s, tm01_s, tm02_s, mean_direction_rad, peak_direction_rad, spread_rad, mss;
  Measured skewness, kurtosis, folded_share;
  double foam_fraction_asked = 0.0;  ///< of the sea, on average; what theory expects where the onset is given
  ocean::FoamOnset foam_onset;
  Measured foam_fraction;  ///< of the whole surface
  /// Sum of k A of the Gerstner waves, and of the cascades 3 sqrt(mss), the steepness that one wave in 90
  /// exceeds: (ka)^2 is 2 mss on average, so that of Rayleigh's waves (Longuet-Higgins 1952) exp(-9 / 2) do.
  double max_ka = 0.0;
};

/// Synthesises the sea with `seeds` seeds, from the scene's own upward, and measures each, with its swells. A
/// loop period is not applied: it moves every wave's frequency to the nearest multiple of the loop's, which
/// is no property of the sea; neither are raindrops. The work hears the share after each seed.
Certificate certify(const ocl::Device& device, const scene::Sea& sea, int seeds, const Work& work);

}  // namespace offing::scene
