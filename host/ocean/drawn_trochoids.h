#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "host/ocean/trochoids.h"

namespace offing::ocean {

/// A trochoid at one time as a shader draws it. At label X, relative to the point that it was drawn for: p =
/// wave . X + phase, height amplitude cos p, shift -shift wave / |wave| sin p.
struct DrawnTrochoid {
  glm::dvec2 wave_radpm{0.0};
  double amplitude_m = 0.0;
  double shift_m = 0.0;    ///< Q A
  double phase_rad = 0.0;  ///< 0 ... 2 pi
};

/// The waves of a sea (without its raindrops) seen from a label, with the phases of TrochoidSurface: reduced
/// in double precision, so that they are as exact 100 km from the origin as at it. Throws what
/// require_valid_trochoids() throws, and Error(bad_input) for a time beyond 1e8 s.
std::vector<DrawnTrochoid> draw_trochoids(const TrochoidSea& sea, glm::dvec2 label_m, double time_s);

}  // namespace offing::ocean
