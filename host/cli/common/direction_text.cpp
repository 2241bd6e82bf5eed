#include "host/cli/common/direction_text.h"

#include <cmath>
#include <numbers>

#include "host/io/spectra/bearings.h"

namespace offing::cli {

double direction_deg(double direction_rad, DirectionStyle style) {
  const double travel_deg = direction_rad * 180.0 / std::numbers::pi;
  const double degrees =
      style == DirectionStyle::travel ? travel_deg : spectra::origin_bearing_deg(travel_deg);
  const double wrapped = degrees - 360.0 * std::floor(degrees / 360.0);
  return wrapped < 360.0 ? wrapped : 0.0;  // a tiny negative angle rounds up to a full turn
}

double travel_deg(double from_bearing_deg) {
  return std::remainder(spectra::direction_from_origin_bearing_deg(from_bearing_deg), 360.0);
}

double direction_difference_rad(double a_rad, double b_rad) {
  return -std::remainder(b_rad - a_rad, 2.0 * std::numbers::pi);
}

const char* direction_unit(DirectionStyle style) {
  return style == DirectionStyle::travel ? "deg, travel" : "deg, from";
}

}  // namespace offing::cli
