#pragma once

#include <optional>

#include "host/base/wave_spectrum.h"
#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::ocean {

/// Models of a sea's spectrum; sources are in docs/sources.md.
enum class SpectrumModel { phillips, pierson_moskowitz, jonswap, tma, swell };
/// TMA's depth factor: Thompson and Vincent's (1983) parabolas, in common use, or Kitaigorodskii's (1975)
/// exact ratio that they approximate.
enum class DepthFactor { thompson_vincent, kitaigorodskii };
/// Models of the spreading over directions; sources are in docs/sources.md.
enum class SpreadingModel { cosine_2s, mitsuyasu, hasselmann, donelan_banner, phillips_cosine };

/// How energy spreads over directions around the mean direction of travel.
struct SpreadingParameters {
  SpreadingModel model = SpreadingModel::hasselmann;
  double direction_rad = 0.0;  ///< mean direction of travel
  double exponent_s = 10.0;    ///< s of cosine_2s, 0 ... 1000
  double swell = 0.0;          ///< xi, 0 ... 1: added elongation of long waves (Horvath 2015)
  /// U10 of the wave age in mitsuyasu and hasselmann. Default: the spectrum's own wind, or for a measured
  /// record the wind of a fully developed sea with its peak.
  std::optional<double> wind_speed_mps;
};

/// A modelled sea. The wind speed is at 19.5 m for pierson_moskowitz and at 10 m for all others.
/// phillips and swell bring a spreading of their own and take only the direction from `spreading`.
///
/// With hs_m, a wind sea (pierson_moskowitz, jonswap, tma) has that height and the period of tz_s, else of
/// tp_s, in water of its depth, in place of wind and fetch; the wind of its wave age then follows from both
/// (fetch_laws.h). pierson_moskowitz then is the shape of gamma = 1. swell takes hs_m and tp_s in place of
/// its own height and period.
struct SpectrumParameters {
  SpectrumModel model = SpectrumModel::jonswap;
  double wind_speed_mps = 10.0;
  double fetch_m = 100e3;
  std::optional<double> hs_m;  ///< 4 sqrt(m0)
  std::optional<double>
      tp_s;  ///< period of the density's peak; absent: a fully developed sea's of this height
  std::optional<double> tz_s;               ///< sqrt(m0 / m2), in place of tp_s
  double gamma = 3.3;                       ///< peak enhancement of jonswap and tma
  std::optional<double> phillips_constant;  ///< A of the paper; default alpha / 2 pi with alpha = 0.0081
  double phillips_cutoff_m = 0.0;           ///< l: damps waves shorter than this
  /// Factor on the variance of waves that travel against the wind, 0 ... 1; the others keep theirs, so m0
  /// drops.
  double phillips_upwind = 1.0;
  DepthFactor depth_factor = DepthFactor::thompson_vincent;  ///< tma only
  double swell_hs_m = 1.0;                                   ///< swell only
  double swell_period_s = 12.0;
  double swell_bandwidth_hz = 0.005;  ///< standard deviation of the Gaussian in frequency
  double swell_exponent_s = 75.0;     ///< s of the swell's cos^2s, the same at all frequencies
  SpreadingParameters spreading;
  Dispersion dispersion;  ///< tma takes its depth from here
};

/// Whether height and period make the wind waves, in place of wind and fetch.
bool is_by_height(const SpectrumParameters& parameters);

/// U10 of a wind that this model takes at its own height.
double wind_at_10_m_mps(SpectrumModel model, double wind_speed_mps);

/// Throws Error(bad_input) that names the parameter and its range when one is out of range or not finite.
SeaSpectrum make_sea_spectrum(const SpectrumParameters& parameters);

/// A measured sea: S(f, theta) is linear between the listed frequencies and directions and zero beyond the
/// first and last frequency, so that m0 and the mean direction are the trapezoidal sums over the file's own
/// grid. A record without directions is spread by `spreading`; one with directions keeps its own. Throws
/// Error(bad_input) for a grid out of order, frequencies below 1e-4 Hz, above 100 Hz or closer than 1e-6 of
/// themselves, a negative or non-finite density, a row of directions that does
/// not integrate to 1 within 1 %, or no energy at all.
SeaSpectrum from_measured(const WaveSpectrum& measured, const SpreadingParameters& spreading,
                          const Dispersion& dispersion);

}  // namespace offing::ocean
