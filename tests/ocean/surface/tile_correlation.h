#pragma once

#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/ocean.h"

namespace offing::ocean {

/// A distance between two labels, m.
struct Lag {
  double x_m = 0.0, z_m = 0.0;
};

/// Correlations of two labels a lag apart: 1 at lag 0.
struct Correlation {
  double height = 0.0;
  double slope = 0.0;  ///< of the slope vector: of dh/dx and dh/dz, each weighted with its variance
};

/// Lags at which a tile would show: 1 to 4 patch lengths of each cascade along x, z and the diagonal.
std::vector<Lag> tile_lags(const std::vector<Cascade>& cascades);

/// Of the spectrum itself up to this wavenumber, in double precision by quadrature.
Correlation correlation_of_spectrum(const SeaSpectrum& spectrum, double k_max_radpm, Lag lag);

/// Of the expected energies of all modes and Gerstner waves: what long records of many seas tend to.
Correlation correlation_of_modes(const Ocean& sea, Lag lag);

/// What two strips of the composed sea, 8 km along x, 64 rows along z and a lag apart, have in common at the
/// sea's present time: the correlation coefficients of pairs of heights and of slopes at labels, this far
/// apart. Patches of some metres are sampled less than once a wave, which is no harm to pairs; Gerstner waves
/// fade if they are (gerstner_surface.h).
Correlation correlation_of_strips(Ocean& sea, Lag lag, double spacing_m);

}  // namespace offing::ocean
