#pragma once

#include <numbers>

namespace offing::cli {

inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

/// How directions are written: of travel from +x toward +z, or as a nautical "from" bearing, clockwise from
/// north.
enum class DirectionStyle { travel, from_bearing };

/// Degrees in [0, 360) of a direction of travel theta in rad. "From" bearing = 270 deg + theta.
double direction_deg(double direction_rad, DirectionStyle style);

/// Degrees of travel, in [-180, 180], of a "from" bearing.
double travel_deg(double from_bearing_deg);

/// Difference of two directions of travel, rad, in [-pi, pi].
double direction_difference_rad(double a_rad, double b_rad);

/// "deg, travel" or "deg, from".
const char* direction_unit(DirectionStyle style);

}  // namespace offing::cli
