#pragma once

#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/analysis/line_of_sight.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::terrain {

/// Where a line of sight comes nearest to the ground.
struct SightClearance {
  double clearance_m = 0.0;  ///< height of the line above the ground, smallest; below 0 the ground hides
  double at_m = 0.0;         ///< from the first end, along the line
  double x_m = 0.0, z_m = 0.0;
  double ground_m = 0.0;  ///< there
};

/// Where the ground comes nearest to the edge of the first Fresnel zone.
struct FresnelClearance {
  double share = 0.0;     ///< clearance over the zone's radius, smallest; 0.6 is usual for a free link
  double at_m = 0.0;      ///< from the first end, along the line
  double radius_m = 0.0;  ///< of the zone there
};

/// The smallest clearance of a line between two ends, both of them included, over ground that falls away by a
/// curve from the first end on. Exact in double precision: within a cell of the grid the clearance is a
/// parabola. Throws what LineOfSight throws.
SightClearance sight_clearance(const TerrainPosts& posts, const EarthCurve& curve, const SightEnd& from,
                               const SightEnd& to);

/// The same for the first Fresnel zone of radio waves, whose radius at distances d1 and d2 from the ends is
/// sqrt(wavelength d1 d2 / (d1 + d2)) (ITU-R P.526). The share is sampled at 8 places of each cell,
/// and the smallest one searched for between the places beside the smallest sample.
FresnelClearance fresnel_clearance(const TerrainPosts& posts, const EarthCurve& curve, const SightEnd& from,
                                   const SightEnd& to, double frequency_hz);

}  // namespace offing::terrain
