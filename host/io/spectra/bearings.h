#pragma once

#include <numbers>

namespace offing::spectra {

/// One degree.
inline constexpr double degree_rad = std::numbers::pi / 180.0;

/// Directions of travel, rad from +x (east) toward +z (south), from what files write. The frame has z to the
/// south, so angles grow clockwise on a map: travel bearing = 90 deg + theta, "from" bearing = 270 deg +
/// theta.
inline double direction_from_travel_bearing(double bearing_rad) {
  return bearing_rad - std::numbers::pi / 2;
}
inline double direction_from_origin_bearing(double bearing_rad) {
  return bearing_rad + std::numbers::pi / 2;
}

/// Back again: the bearing toward which a direction of travel points. Not wrapped.
inline double travel_bearing(double direction_rad) {
  return direction_rad + std::numbers::pi / 2;
}

/// "From" bearings both ways in degrees, as people write them; whole degrees stay whole. Not wrapped.
inline double direction_from_origin_bearing_deg(double bearing_deg) {
  return bearing_deg + 90.0;
}
inline double origin_bearing_deg(double direction_deg) {
  return direction_deg - 90.0;
}

/// `angle_rad` is of travel, counterclockwise from a model's x axis, taken to point east.
inline double direction_from_cartesian(double angle_rad) {
  return -angle_rad;
}

}  // namespace offing::spectra
