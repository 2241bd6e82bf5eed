#pragma once

#include <vector>

namespace offing::clouds {

/// Lumps smaller than particles, for clouds that are marched (kernels/clouds/march/cloud_march.cl): a cube
/// [CLOUD_LUMP_TEXELS z][y][x] that goes on at its sides, of mean 0 and variance 1. Round outward with sharp
/// valleys between: a sum of octaves of |noise| (Perlin & Hoffert 1989, "Hypertexture"). The same on all
/// machines.
std::vector<float> lump_noise();

}  // namespace offing::clouds
