#pragma once

#include <string_view>

#include "host/ocean/spectrum/dispersion.h"

namespace offing::ocean {

/// The most cascades of a sea, and the most samples along a side of their patches.
inline constexpr int most_cascades = 4, largest_size = 4096;

/// offing::require_within() of "ocean.<name>"; `name` carries the unit.
void require_within(std::string_view name, double value, double low, double high);

/// Throws Error(bad_input) unless gravity, depth (0.1 m ... infinite) and capillary length are physical.
void require_valid_dispersion(const Dispersion& dispersion);

/// Throws Error(bad_input) unless a patch can have this many samples along a side: a power of two, 16 ...
/// 4096.
void require_valid_size(int size);

}  // namespace offing::ocean
