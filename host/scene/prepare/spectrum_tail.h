#pragma once

#include "host/base/wave_spectrum.h"

namespace offing::scene {

/// The record continued beyond its last frequency up to `highest_hz` as f^-5, the equilibrium range of wind
/// waves (Phillips 1958), with the directions of its last frequency. Buoys stop near 0.5 Hz, at waves of some
/// 6 m: without a tail a picture of their sea lacks all that is shorter. Unchanged if the record reaches as
/// far by itself, within a thousandth.
WaveSpectrum with_tail(WaveSpectrum record, double highest_hz);

}  // namespace offing::scene
