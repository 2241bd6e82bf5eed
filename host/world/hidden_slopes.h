#pragma once

#include <vector>

#include "host/ocean/spectrum/slope_covariance.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/ocean.h"

namespace offing::world {

/// Slopes that a picture must not draw one by one.
struct HiddenSlopes {
  /// [cascade][level]: what the mip levels of its slope map hide.
  std::vector<std::vector<ocean::SlopeCovariance>> cascades;
  /// All slopes of the Gerstner waves, for grids too coarse to draw them.
  ocean::SlopeCovariance gerstner_waves;
  /// Of ripples that neither cascades nor Gerstner waves have.
  ocean::SlopeCovariance ripples;
};

/// The wind over ripples, at 10 m.
struct RippleWind {
  double speed_mps = 10.0;
  double direction_rad = 0.0;
};

/// What the mip levels of each cascade hide, of the expected variances of its modes [n][n] m^2.
std::vector<std::vector<ocean::SlopeCovariance>> hidden_by_levels(
    const ocean::OceanParameters& ocean, const std::vector<std::vector<float>>& variances);

/// Of the slopes that the wind makes, what Gerstner waves and cascades leave is the ripples'.
HiddenSlopes shared_out(std::vector<std::vector<ocean::SlopeCovariance>> cascades,
                        const std::vector<ocean::GerstnerWave>& gerstner_waves, const RippleWind& wind);

}  // namespace offing::world
