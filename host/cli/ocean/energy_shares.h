#pragma once

#include <string>
#include <vector>

#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// How the energy of a sea lies in its cascades, from the spectrum alone.
struct EnergyShares {
  double m0_m2 = 0.0;                 ///< of the whole spectrum
  double gerstner_m0_m2 = 0.0;        ///< longer than the first band, where that begins at a split
  std::vector<double> cascade_m0_m2;  ///< within each cascade's band
  double out_of_band_m2 = 0.0;        ///< of neither
};

EnergyShares energy_shares(const ocean::SeaSpectrum& spectrum, const std::vector<ocean::Cascade>& cascades);

/// The cascades with their bands and the energy that each holds.
std::string cascade_text(const scene::Sea& sea, const EnergyShares& energy);

}  // namespace offing::cli
