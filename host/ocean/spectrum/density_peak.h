#pragma once

#include <functional>
#include <span>

namespace offing::ocean {

/// Energy of the waves whose frequencies lie in [low_hz, high_hz).
struct FrequencyBin {
  double low_hz = 0.0, high_hz = 0.0;
  double energy_m2 = 0.0;
  double waves = 0.0;  ///< m0^2 / sum of V^2 of its waves' expected energies V; for the error alone
};

/// The frequency at which the energy density is largest.
struct DensityPeak {
  double frequency_hz = 0.0;
  double error =
      0.0;  ///< standard deviation for realised seas, relative; 0 for bins without a number of waves
};

/// Where the density behind these energies is largest, if it has the shape of `density_m2phz` around its peak
/// at peak_hz: that peak, moved by the factor on frequency with which the shape fits best. The bins meet, in
/// increasing order; their energies are those of one realised sea, or those expected.
///
/// The fit takes the bins around the peak whose density is above 0.3 of its largest. Energies scatter in
/// proportion to their mean, so that the likelihood of bins of n waves, n as f^3 df, is -sum of n (ln m + e /
/// m) with the mean m (McCullagh and Nelder 1989, chapter 8); its factor on height is free. Factors on
/// frequency from 0.78 to 1.28 are tried. The error is the spread of the same estimate to first order in the
/// scatter.
DensityPeak peak_of(std::span<const FrequencyBin> bins, const std::function<double(double hz)>& density_m2phz,
                    double peak_hz);

}  // namespace offing::ocean
