#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/ocean/spectrum/dispersion.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "kernels/shared/shoal_params.h"

namespace offing::ocean {

/// Significant wave height over depth where waves break on a beach: the root mean square height of 0.42 of
/// the depth that Thornton & Guza 1982 measured, times the root of 2 by which significant waves are higher
/// (Rayleigh).
inline constexpr double breaking_share = 0.5939696961966999;

/// Waves that shoal alike: all as long as the mean of them, weighted by their energy.
struct ShoalingBand {
  double variance_m2 = 0.0;  ///< of the surface; 0: there are none
  double wavenumber_radpm = 0.0;
};

/// The bands of a sea: those of its cascades, then of Gerstner waves, from long waves to short.
struct SeaBands {
  std::array<ShoalingBand, SHOAL_BANDS> bands{};
  /// Gerstner waves with a wavenumber from edge i on are of band i + 1 or beyond, rad/m.
  std::array<double, SHOAL_BANDS - SHOAL_FIRST_GERSTNER - 1> edges_radpm{};

  /// The band of a Gerstner wave, 0 ... 3, from the first of Gerstner waves on.
  int gerstner_band(double wavenumber_radpm) const;
};

/// The band of a cascade whose modes have these expected variances, [size][size] m^2
/// (Ocean::mode_variance()).
ShoalingBand band_of_modes(std::span<const float> variance_m2, int size, double patch_length_m);

/// Those of cascades, with bands of Gerstner waves whose edges lie midway, by ratio, between waves: as many
/// wave by wave as there are bands, else of equal ratio.
SeaBands shoaling_bands(std::span<const ShoalingBand> cascades, std::span<const GerstnerWave> gerstner_waves);

/// By how much a wave's height grows from the sea's own depth to another, of conserved energy flux at a
/// frequency that stays: sqrt(cg(sea) / cg(there)), linear theory (Dean & Dalrymple 1991, chapter 4).
/// `wavenumber_radpm` is that in the sea's own depth; the depth is above 0.
double shoaling_coefficient(const Dispersion& sea, double wavenumber_radpm, double depth_m);

/// What is left of the heights of each band over shoals, by the depth alone. Linear theory lets each band
/// shoal; then the whole sea is held below the height at which waves break: with H its significant height
/// where it would be without breaking and x = H / (breaking_share depth), all bands become (1 + x^4)^(-1/4)
/// of what they were. So the significant height stays below breaking_share of the depth and goes to 0 with
/// it. A sea that is so high for its own depth that it breaks there is taken as it is given.
///
/// Left out: waves keep their length and direction (no refraction), are not sheltered behind land and not
/// mirrored by it, and what breaks on a bar is there again in the deeper water behind it.
class ShoalTable {
 public:
  ShoalTable() = default;
  /// `sea` says how deep the open sea is. Throws Error(bad_input) for bands that are not finite.
  ShoalTable(const Dispersion& sea, const SeaBands& bands);

  /// At this depth and below the sea is the open sea, m.
  double deepest_m() const { return deepest_m_; }
  /// [SHOAL_STEPS][SHOAL_BANDS]; kernels/shared/shoal_params.h has the depths of its rows.
  const std::vector<float>& shares() const { return shares_; }
  const SeaBands& bands() const { return bands_; }
  /// The largest of all, 1 or more: how much higher than in the open sea waves may stand before they break.
  double largest_share() const { return largest_share_; }
  /// Of each band at this depth: the table, linear between its rows, in double precision.
  std::array<double, SHOAL_BANDS> at(double depth_m) const;

 private:
  SeaBands bands_;
  double deepest_m_ = 0.0, largest_share_ = 1.0;
  std::vector<float> shares_;
};

}  // namespace offing::ocean
