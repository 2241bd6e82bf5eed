#pragma once

#include "host/base/sea/modal_sea.h"
#include "host/base/wave_spectrum.h"

namespace offing::ocean {

/// The spectrum of the waves on patches: each wave's energy goes to the two frequencies and directions beside
/// its own, by its distance from them, so that variance and mean frequency are exact. 64 frequencies between
/// the lowest and the highest, 72 directions. Throws Error(bad_input) if no patch has a wave.
WaveSpectrum spectrum_of(const ModalSea& modes);

}  // namespace offing::ocean
