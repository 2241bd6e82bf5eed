#pragma once

#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/ocean.h"

namespace offing::scene {

/// How the energy of a sea lies in its cascades, from the spectrum alone.
struct EnergyShares {
  double m0_m2 = 0.0;                 ///< of the whole spectrum
  double gerstner_m0_m2 = 0.0;        ///< longer than the first band, where that begins at a split
  std::vector<double> cascade_m0_m2;  ///< within each cascade's band
  double out_of_band_m2 = 0.0;        ///< of neither
};

EnergyShares energy_shares(const ocean::SeaSpectrum& spectrum, const std::vector<ocean::Cascade>& cascades);

}  // namespace offing::scene
