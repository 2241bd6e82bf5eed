#pragma once

#include <cstdint>

#include "host/ocean/query/water_query.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "kernels/shared/gerstner_params.h"

/// Gerstner waves and rings as kernels read them.
namespace offing::ocean {

/// A phase as kernels read it: in 2^-32 turns, without whole ones.
std::uint32_t device_turns(double turns);

/// The ring of a drop at this time, with its centre seen from `origin`; without height before the drop falls.
GerstnerRing device_ring(const Raindrop& drop, double time_s, const Dispersion& dispersion,
                         const WaterPoint& origin);

/// Whether a ring is high enough to count: a micrometre.
bool is_visible(const GerstnerRing& ring);

}  // namespace offing::ocean
