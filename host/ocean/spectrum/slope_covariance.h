#pragma once

#include <span>
#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/spectrum/wind.h"

namespace offing::ocean {

/// Covariance of the slopes dh/dx and dh/dz.
struct SlopeCovariance {
  double xx = 0.0, xz = 0.0, zz = 0.0;

  double mean_square() const { return xx + zz; }
};

/// What averaging takes from the slopes of one cascade: entry i is the covariance that blocks of 2^i x 2^i
/// texels hide, as the levels of a mip-mapped slope map do; entry 0 is zero, the last one is all slopes that
/// the cascade has. variance [size][size] m^2 as Ocean::mode_variance() gives it; log2(size) + 1 entries.
/// Throws Error(bad_input) if the array has another size.
std::vector<SlopeCovariance> hidden_slopes(std::span<const float> variance, int size, double patch_length_m);

/// Covariance of all slopes of a clean sea in this wind (at 10 m), down to the shortest ripples, measured
/// from the sun's glitter: 0.003 + 0.00192 U across and 0.00316 U along the wind (Cox & Munk 1954, whose wind
/// was at 12.4 m: within 2 %).
SlopeCovariance measured_slopes(const Wind& wind);

/// `all` less the mean square of `resolved`: the shape of `all`, scaled down, to `least` of it at least,
/// since a model sea may be steeper than the measured one.
SlopeCovariance remaining_slopes(const SlopeCovariance& all, const SlopeCovariance& resolved,
                                 double least = 0.1);

}  // namespace offing::ocean
