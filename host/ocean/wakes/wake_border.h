#pragma once

#include <vector>

#include "host/ocean/wakes/wake_parameters.h"

namespace offing::ocean {

/// The border of a wake window, an eighth of its side wide, in which waves die away: those that leave neither
/// come back nor enter again at the other side, although the window is periodic.
///
/// With u the way from the outer edge in widths, all water is damped at the rate (1 - u)^2 r, r such that a
/// wave as long as the border is wide keeps e^-5 of its height on its way through the borders of both sides.
/// The profile grows so slowly that such a wave is reflected by 1 %, and shorter ones by less.
struct WakeBorder {
  std::vector<float> kept;   ///< [n]: share of the water's height that each column keeps in a step
  std::vector<float> blend;  ///< [n][2]: share that is shown, 0 at both ends, and its derivative, 1/m
};

/// Width of the border, m.
double wake_border_m(const WakeParameters& parameters);

/// For one of the equal parts into which a step is divided.
WakeBorder make_wake_border(const WakeParameters& parameters, double part_s);

}  // namespace offing::ocean
