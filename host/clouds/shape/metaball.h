#pragma once

namespace offing::clouds {

/// What a metaball of radius 1 sums up to: the integral of h over its volume, 0.815595 (C1).
extern const double ball_mass;

/// Its mean squared distance from the middle, weighted by h; of a ball of radius R times R^2.
extern const double ball_variance;

/// h of C1 at a distance from the middle, in radii: 1 there, 0 from 1 on, with a slope of 0 at both.
/// Wyvill, McPheeters, Wyvill 1986, "Data structure for soft objects".
double ball_profile(double distance);

/// The integral of h along a line that passes the middle at a distance, both in radii; 0 from 1 on.
double ball_chord(double distance);

}  // namespace offing::clouds
