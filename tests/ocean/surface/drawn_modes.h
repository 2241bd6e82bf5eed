#pragma once

#include <cstdint>
#include <vector>

#include "host/ocean/surface/wave_modes.h"
#include "tests/ocean/surface/ocean_reference.h"

namespace offing::ocean {

/// What the device drew, unpacked from the half plane that it keeps (WaveModes::amplitude(), rate()) into
/// [n][n], row-major, K = 0 at [0][0]. The Nyquist row and column are 0.
ComplexField drawn_amplitudes(const WaveModes& modes, int cascade);  ///< h0(K), m
std::vector<std::uint32_t> drawn_rates(const WaveModes& modes, int cascade);

}  // namespace offing::ocean
