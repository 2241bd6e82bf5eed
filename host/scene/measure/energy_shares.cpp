// How the energy of a sea lies in its cascades.
#include "host/scene/measure/energy_shares.h"

#include <algorithm>

#include "host/ocean/spectrum/sea_statistics.h"

namespace offing::scene {

EnergyShares energy_shares(const ocean::SeaSpectrum& spectrum, const std::vector<ocean::Cascade>& cascades) {
  EnergyShares shares;
  shares.m0_m2 = ocean::integrate_sea_state(spectrum).m0_m2;
  for (const ocean::Cascade& cascade : cascades) {
    shares.cascade_m0_m2.push_back(
        ocean::integrate_sea_state(spectrum, cascade.k_min_radpm, cascade.k_max_radpm).m0_m2);
  }
  const double split_radpm = cascades.front().k_min_radpm;
  shares.gerstner_m0_m2 = ocean::integrate_sea_state(spectrum, 0.0, split_radpm).m0_m2;
  // Waves longer than the first patch fall into its K = 0, which moves nothing.
  const double too_long_m2 =
      ocean::still_cell_variance_m2(spectrum, cascades.front().patch_length_m, split_radpm);
  shares.cascade_m0_m2.front() -= std::min(too_long_m2, shares.cascade_m0_m2.front());
  shares.out_of_band_m2 =
      too_long_m2 + ocean::integrate_sea_state(spectrum, cascades.back().k_max_radpm).m0_m2;
  return shares;
}

}  // namespace offing::scene
