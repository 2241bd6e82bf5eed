#pragma once

namespace offing::height_maps {

inline constexpr double wgs84_radius_m = 6378137.0, wgs84_flattening = 1.0 / 298.257223563;

/// Length of a degree on the ground.
struct DegreeLength {
  double east_m = 0.0;   ///< along the parallel
  double north_m = 0.0;  ///< along the meridian
};

/// On an ellipsoid of that equatorial radius and flattening, at a geodetic latitude: the prime vertical and
/// meridian radii of curvature, times pi / 180. Torge & Mueller 2012, Geodesy, section 4.1.3.
DegreeLength degree_length(double latitude_deg, double equatorial_radius_m, double flattening);

}  // namespace offing::height_maps
