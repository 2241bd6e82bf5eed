#pragma once

#include "host/base/wave_spectrum.h"
#include "host/scene/prepare/sea.h"

namespace offing::scene {

/// The sea as an instrument would report it, for export. A measured record is kept as it is; if it has no
/// directions, it gets those that it was spread by, 72 a frequency. A modelled sea is sampled at 99
/// frequencies, evenly spaced in their logarithm up to at most ten times the peak's: of a wind sea, whose
/// energy falls as f^-5, 1e-4 of m0 lies beyond. So is a record with irregular swells.
WaveSpectrum sampled_spectrum(const Sea& sea);

}  // namespace offing::scene
