#pragma once

#include <optional>

#include "host/base/wave_spectrum.h"
#include "host/ocean/sea_spectrum.h"

namespace offing::ocean {

enum class SpectrumModel { phillips, pierson_moskowitz, jonswap, tma, swell };
enum class SpreadingModel { cosine_2s, mitsuyasu, hasselmann, donelan_banner, phillips_cosine };

/// How energy spreads over directions around the mean direction of travel.
struct SpreadingParameters {
  SpreadingModel model = SpreadingModel::hasselmann;
  double direction_rad = 0.0;  ///< mean direction of travel
  double exponent_s = 10.0;    ///< s of cosine_2s
  double swell = 0.0;          ///< 0 ... 1: added elongation of long waves (Horvath 2015)
  double wind_speed_mps = 10.0;  ///< U10, for the wave-age dependent models
};

/// A modelled sea (PAPERS O5). The wind speed is at 19.5 m for pierson_moskowitz and at 10 m for all others.
struct SpectrumParameters {
  SpectrumModel model = SpectrumModel::jonswap;
  double wind_speed_mps = 10.0;
  double fetch_m = 100e3;
  double gamma = 3.3;                       ///< peak enhancement of jonswap and tma
  std::optional<double> phillips_constant;  ///< A of the paper; default alpha / 2 pi with alpha = 0.0081
  double phillips_cutoff_m = 0.0;           ///< l: damps waves shorter than this
  double phillips_upwind = 1.0;             ///< factor on waves that travel against the wind, 0 ... 1
  double swell_hs_m = 1.0;                  ///< swell only
  double swell_period_s = 12.0;
  double swell_bandwidth_hz = 0.005;        ///< standard deviation of the Gaussian in frequency
  SpreadingParameters spreading;
  Dispersion dispersion;  ///< tma takes its depth from here
};

/// Throws Error(bad_input) that names the parameter and its range when one is out of range or not finite.
SeaSpectrum make_sea_spectrum(const SpectrumParameters& parameters);

/// A measured sea. A record without directions is spread by `spreading`; one with directions keeps its own.
SeaSpectrum from_measured(const WaveSpectrum& measured, const SpreadingParameters& spreading,
                          const Dispersion& dispersion);

}  // namespace offing::ocean
