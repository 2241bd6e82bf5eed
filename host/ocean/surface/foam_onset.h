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

/// Foam of more of the sea cannot be asked for.
inline constexpr double most_foam = 0.5;

/// Share of the sea that whitecaps cover in a wind at 10 m: 3.84e-6 U^3.41 (Monahan & O'Muircheartaigh 1980)
/// from 8 m/s on, below that running smoothly into 3.18e-5 (U - 3.70)^3 (Callaghan and others 2008), 0 up to
/// 3.7 m/s. At most most_foam, as in 31.6 m/s: nobody has counted whitecaps in stronger winds.
double whitecap_fraction(double wind_mps);

/// The choppiness of the deformation that foam goes by: the sea's, or 1 for a sea without any, whose crests
/// are as high and foam as much.
double foam_choppiness(double choppiness);

/// What foam expects of the deformation of a sea's cascades, by theory.
struct FoamOnset {
  double jacobian = 0.0;  ///< at which foam begins
  double width = 0.0;     ///< below that at which coverage is full
  double fraction = 0.0;  ///< expected area mean of the foam of all cascades together
  /// The foam that the waves of one cascade make.
  struct CascadeFoam {
    double deviation = 0.0;        ///< of the compression, -(d dx/dx + d dz/dz)
    std::vector<double> survival;  ///< share of the area with more foam than (i + 1/2) / size
    double mean = 0.0;             ///< of the foam of this cascade
  };
  std::vector<CascadeFoam> cascades;

  bool has_foam() const { return fraction > 0.0; }
};

/// The onset and width of these parameters. Those that they leave open follow from the spectrum: the onset so
/// that foam, decay and all, covers foam.fraction of the sea on average, and the width as the mean depth by
/// which folding crests fall below it.
///
/// The compression -T = -(d dx/dx + d dz/dz) of a cascade is Gaussian, with variance and correlation from the
/// spectrum. With R the length of the mean of (cos 2 theta, sin 2 theta) over it, J = det F is on average
/// 1 + T + (1 - R^2) / 4 (T^2 - var T) where T is known; that is taken for J. Foam at a label is above a
/// level unless T stays above a threshold at every past instant; from instant to instant T is taken for a
/// Markov chain. Measured: areas are right within 20 %.
FoamOnset foam_onset(const SeaSpectrum& spectrum, std::span<const Cascade> cascades, double choppiness,
                     const FoamParameters& foam, std::optional<double> loop_period_s = {});

/// How longer waves gather the foam of one cascade: where Gerstner waves and longer cascades compress the
/// surface by p, there is min(1, factor exp(steepness p)) times as much, and as much as without them on
/// average.
struct FoamGathering {
  double factor = 1.0;
  double steepness = 0.0;
  double variance = 0.0;  ///< of p
};

/// Of each cascade, from the theory of the whole surface: a cascade folds where its compression exceeds its
/// threshold less p. So the crests of longer waves have more foam, their troughs less. `choppiness` is that
/// of the sea: without any, nothing is compressed.
std::vector<FoamGathering> foam_gathering(const FoamOnset& onset, const GerstnerSea& gerstner_waves,
                                          double choppiness);

/// Variance of the compression by these waves.
double compression_variance(const GerstnerSea& gerstner_waves);

}  // namespace offing::ocean
