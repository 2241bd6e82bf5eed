#pragma once

#include <span>

#include "host/io/png_image.h"
#include "host/ocean/query/gerstner_instant.h"
#include "host/ocean/surface/ocean.h"

namespace offing::cli {

/// One cascade of a sea, as Ocean::read_surface() and Ocean::read_foam() give it.
struct SeaMapCascade {
  double patch_length_m = 0.0;
  const ocean::SurfaceFields* surface = nullptr;
  std::span<const float> foam;  ///< [n][n] 0 ... 1, or empty
};

/// A shaded map of the sea from above: the heights of all cascades and long waves over the first cascade's
/// patch, x to the right and z downward, lit from the upper left, with foam in white. Colours go from dark to
/// bright water within `hs_m` (m, > 0) above and below the mean level, so that the frames of a sea compare.
/// Slopes are drawn three times as steep as they are. A side has 256 to 1024 pixels, the samples of a cascade
/// where it can; waves shorter than a pixel are averaged away. Points stand at their rest labels: horizontal
/// displacement is left out. Throws Error(bad_input) without a cascade.
RgbImage draw_sea_map(std::span<const SeaMapCascade> cascades, const ocean::GerstnerInstant& long_waves,
                      double hs_m);

}  // namespace offing::cli
