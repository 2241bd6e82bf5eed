#pragma once

#include <vector>

#include "host/ocean/surface/ocean.h"

namespace offing::ocean {

/// A wind sea of 12 m/s: 16 Gerstner waves for the long waves, two cascades of n x n for the others.
struct HybridSea {
  SeaSpectrum spectrum;
  Ocean ocean;
};

HybridSea hybrid_sea(const ocl::Device& device, int size, double choppiness = 1.0);

/// Points within half this distance of the origin along x and z, of a fixed seed.
std::vector<WaterPoint> scattered_points(int count, double width_m);

}  // namespace offing::ocean
