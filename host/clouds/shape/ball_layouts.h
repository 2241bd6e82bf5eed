#pragma once

#include <cstdint>
#include <vector>

#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// Metaballs of the genera (C6, C15), in metres, the base at y = 0, spread along x; the same for the same
/// seed.
std::vector<Metaball> ball_layout(Genus genus, std::uint64_t seed);

}  // namespace offing::clouds
