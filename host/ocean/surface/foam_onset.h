#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/foam_parameters.h"
#include "host/ocean/surface/gerstner_waves.h"

/// Where foam begins, so that it covers as much of a sea as whitecaps do.
namespace offing::ocean {

/// The largest `fraction` that can be asked for.
inline constexpr double most_foam = 0.5;

/// Share of the sea that whitecaps cover, for the wind U at 10 m. From 8 m/s on it is 3.84e-6 U^3.41 (Monahan
/// & O'Muircheartaigh 1980). Below, a smooth curve falls to 3.18e-5 (U - 3.70)^3 (Callaghan and others 2008),
/// which is 0 up to 3.7 m/s. At most most_foam, reached at 31.6 m/s: nobody has counted whitecaps in stronger
/// winds.
double whitecap_fraction(double wind_mps);

/// The choppiness that foam is computed with: the sea's. A sea of choppiness 0 uses 1, because its crests are
/// as high and foam as much.
double foam_choppiness(double choppiness);

/// Where foam begins in a sea's cascades, and how much there is by theory.
struct FoamOnset {
  double jacobian = 0.0;  ///< at which foam begins
  double width = 0.0;     ///< of J below the onset, at which coverage is full
  double fraction = 0.0;  ///< expected mean over the area of the foam of all cascades
  /// The foam that the waves of one cascade make.
  struct CascadeFoam {
    double deviation = 0.0;        ///< of the compression, -(d dx/dx + d dz/dz)
    std::vector<double> survival;  ///< share of the area with more foam than (i + 1/2) / size
    double mean = 0.0;             ///< expected mean over the area of this cascade's foam
  };
  std::vector<CascadeFoam> cascades;

  bool has_foam() const { return fraction > 0.0; }
};

/// The onset and width that these parameters set. If a parameter is absent, it follows from the spectrum: the
/// onset so that foam covers foam.fraction of the sea on average, its decay included; the width as the mean
/// of onset - J over folding crests.
///
/// The compression -T = -(d dx/dx + d dz/dz) of a cascade is Gaussian, with variance and correlation from the
/// spectrum. R is the length of the mean of (cos 2 theta, sin 2 theta) over its variance. For a given T, the
/// mean of J = det F is 1 + T + (1 - R^2) / 4 (T^2 - var T), which is taken for J. Foam at a label is below a
/// level if T stays above a threshold at every past instant; from instant to instant T is taken for a
/// Markov chain. Measured: areas are right within 20 %.
FoamOnset foam_onset(const SeaSpectrum& spectrum, std::span<const Cascade> cascades, double choppiness,
                     const FoamParameters& foam, std::optional<double> loop_period_s = {});

/// How longer waves gather the foam of one cascade. Where Gerstner waves and longer cascades compress the
/// surface by p, foam is min(1, factor exp(steepness p)) times as much. Its mean over the area is the same as
/// without them.
struct FoamGathering {
  double factor = 1.0;
  double steepness = 0.0;
  double variance = 0.0;  ///< of p
};

/// The gathering of each cascade: a cascade folds where its compression exceeds its threshold minus p. So the
/// crests of longer waves have more foam, their troughs less. `choppiness` is the sea's: at 0 nothing is
/// compressed.
std::vector<FoamGathering> foam_gathering(const FoamOnset& onset, const GerstnerSea& gerstner_waves,
                                          double choppiness);

/// Variance of the compression by these waves.
double compression_variance(const GerstnerSea& gerstner_waves);

}  // namespace offing::ocean
