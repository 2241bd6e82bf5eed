#pragma once

#include <string_view>

/// The ranges of parameters: the check, and limits that several simulations share.
namespace offing {

/// How far from the origin of the world places may be along x or z, m: half way around the Earth.
inline constexpr double farthest_point_m = 2e7;

/// How far from 0 times may be, s: three years, in which phases of waves stay exact
/// (host/ocean/surface/wave_clock.h).
inline constexpr double largest_time_s = 1e8;

/// How far below the surface there may be water, m: what lies deeper is not asked for, even where a sea has
/// no bed.
inline constexpr double deepest_m = 12000.0;

/// Throws Error(bad_input) that names the parameter, its range and the value found, unless low <= value <=
/// high. NaN is outside every range; `name` carries section and unit: "ocean.depth_m".
void require_within(std::string_view name, double value, double low, double high);

}  // namespace offing
