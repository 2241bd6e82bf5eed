// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <cstddef>

/// The peer's own loop over points, compiled for this very processor and with -ffast-math.
namespace offing::bench::peer {

/// Points that the loop takes at a time.
inline constexpr int query_tile = 64;

struct QueryWave {
  double kx_radpm, kz_radpm, phase_rad;  // at the origin, at this time
  // Factors of the cosine: h, d dx/dx, d dx/dz, d dz/dz, vx, vz, head; and of the sine: dx, dz, dh/dx, dh/dz,
  // vy.
  float cosine[7], sine[5];
};

struct QueryCascade {
  const float* displacement;  // [n][n] float4, as ocean::SurfaceMaps and ocean::VelocityMap have them
  const float* gradient;
  const float* flow;  // null: neither velocity nor pressure
  double patch_length_m;
};

struct QuerySea {
  const QueryWave* waves;
  int wave_count;
  const QueryCascade* cascades;
  int cascade_count;
  int size;
  float weight_papm, tolerance_m;
};

/// Answers for query_tile points (x, z): [point][8] h, slope x, slope z, residual, vx, vy, vz, pressure.
void query_points(const QuerySea& sea, const double* points_xz, float* samples);

}  // namespace offing::bench::peer
