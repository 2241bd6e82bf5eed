#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "host/cli/pictures/preview_surface.h"

namespace offing::cli {

/// Fields of the right sizes that are all zero: a calm sea.
inline ocean::SurfaceFields calm_sea(int size) {
  const std::vector<float> zeros(static_cast<std::size_t>(size) * size);
  return {size, zeros, zeros, zeros, zeros, zeros, zeros, zeros, zeros, zeros, zeros};
}

/// One wave along +x, amplitude a, `waves` of them over the patch, choppiness 1: at label x the elevation is
/// a cos(k x) and the shift -a sin(k x) (O7 of docs/sources.md).
inline ocean::SurfaceFields one_wave(int size, double patch_length_m, int waves, double amplitude_m) {
  ocean::SurfaceFields fields = calm_sea(size);
  const double k_radpm = 2.0 * std::numbers::pi * waves / patch_length_m;
  for (std::size_t i = 0; i < fields.displacement_y.size(); ++i) {
    const double phase = k_radpm * patch_length_m / size * static_cast<double>(i % size);
    fields.displacement_x[i] = static_cast<float>(-amplitude_m * std::sin(phase));
    fields.displacement_y[i] = static_cast<float>(amplitude_m * std::cos(phase));
    fields.slope_x[i] = static_cast<float>(-amplitude_m * k_radpm * std::sin(phase));
    fields.gradient_xx[i] = static_cast<float>(-amplitude_m * k_radpm * std::cos(phase));
  }
  return fields;
}

/// The same sea with independent normal slopes added in every sample: the hardest case for a filter.
inline ocean::SurfaceFields with_noise(ocean::SurfaceFields fields, float deviation) {
  std::mt19937 random(5);
  std::normal_distribution<float> normal(0.0f, deviation);
  for (float& slope : fields.slope_x) slope += normal(random);
  for (float& slope : fields.slope_z) slope += normal(random);
  return fields;
}

inline ocean::SurfaceFields noisy_slopes(int size, float deviation) {
  return with_noise(calm_sea(size), deviation);
}

inline PreviewSurface surface_of(const ocean::SurfaceFields& fields, double patch_length_m) {
  const PreviewCascade cascade{patch_length_m, &fields, {}};
  return PreviewSurface({&cascade, 1}, {});
}

}  // namespace offing::cli
