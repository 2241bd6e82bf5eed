#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/base/sea/modal_sea.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/wave_clock.h"

namespace offing::ocean {

/// The modes of some cascades as WaveModes has them on the device.
struct ModeArrays {
  std::vector<float> amplitude;     ///< [cascades][4][columns/16][n][16] m
  std::vector<std::uint32_t> rate;  ///< [cascades][columns/16][n][16]
};

/// The shape of these arrays.
struct ModeShape {
  std::span<const Cascade> cascades;
  int size = 0;     ///< n
  int columns = 0;  ///< WaveModes::columns()
};

/// The waves that these arrays stand for, patch by patch. Left out are waves 2^-22 as high as the one that
/// runs against them or lower, which the arrays' numbers do not hold.
std::vector<SeaMode> list_modes(const ModeArrays& arrays, const ModeShape& shape, const WaveClock& clock);

/// Writes the waves of these cascades' patches over what `arrays` have. Patches beyond the cascades, and
/// modes whose cells are beyond a cascade's band or lattice, have no place and are left out. Returns the
/// variance of each mode, one [n][n] m^2 a cascade, K = 0 at [0][0]. Throws Error(bad_input) where waves that
/// run against each other have frequencies that the clock can tell apart, or one is faster than the clock.
std::vector<std::vector<float>> place_modes(const ModalSea& modes, const ModeShape& shape,
                                            const WaveClock& clock, ModeArrays& arrays);

}  // namespace offing::ocean
