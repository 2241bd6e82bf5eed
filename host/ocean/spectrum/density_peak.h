#pragma once

#include <span>

namespace offing::ocean {

/// Energy of the waves whose frequencies lie in [low_hz, high_hz).
struct FrequencyBin {
  double low_hz = 0.0, high_hz = 0.0;
  double energy_m2 = 0.0;
  double waves = 0.0;  ///< m0^2 / sum of V^2 of its waves' expected energies V; for the error alone
};

struct DensityPeak {
  double frequency_hz = 0.0;
  /// Standard deviation of the same for realised seas, relative; 0 where the bins have no number of waves.
  double error = 0.0;
};

/// Where the density behind these energies is largest. The bins meet, in increasing
/// order; their energies are those of one realised sea, which scatter as sums of a few exponential ones, or
/// those expected.
///
/// Smoothed over 6 % of frequency, the density is above 0.6 of its largest value in a range around its peak.
/// There ln E = a + b ln f + c f^-4, the form of wind seas (Pierson and Moskowitz 1964), is fitted with the
/// weights of such energies (McCullagh and Nelder 1989, chapter 8); its maximum is at f^4 = 4 c / b.
/// JONSWAP's peaks of gamma 1 to 7 come out within 0.4 % from expected energies, Gaussian swells within 0.5
/// %; of one realised sea they scatter by 0.1 to 2 %, the more the wider the peak and the fewer the waves.
/// The error is that of the fit to expected energies whose sums scatter as those of `waves` equal ones; that
/// the range scatters too is left out.
DensityPeak peak_of(std::span<const FrequencyBin> bins);

}  // namespace offing::ocean
