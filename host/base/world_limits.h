#pragma once

namespace offing {

/// How far from the origin of the world places may be along x or z, m: half way around the Earth.
inline constexpr double farthest_point_m = 2e7;

/// How far from 0 times may be, s: three years, in which phases of waves stay exact (ocean/wave_clock.h).
inline constexpr double largest_time_s = 1e8;

/// How far below the surface there may be water, m: what lies deeper is not asked for, even where a sea has
/// no bed.
inline constexpr double deepest_m = 12000.0;

}  // namespace offing
