// How much of a highlight its light reaches past the mesh.
#include "host/highlights/tracks/light_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace offing::highlights {
namespace {

// Rays of LightShadow start on rings within this share of the half widths.
constexpr double tested_share = 0.5;
constexpr int rings = 3, places_a_ring = 8;
// They start this share of the smaller half width above the surface: what bends up within the rings, by half
// the square of tested_share times 0.31 (the sine at the usual threshold), is lower.
constexpr double lift_share = 0.06;

}  // namespace

double LightShadow::lit_share(const Projector& projector, const Source& light) const {
  const double half_m = 0.5 * std::min(projector.width_m, projector.height_m);
  const glm::dvec3 middle_m =
      projector.centre_m + projector.normal * std::max(lift_share * half_m, touching_m_);
  int lit = 0, all = 0;
  const auto test = [&](double right_share, double up_share) {
    const glm::dvec3 place_m = middle_m + projector.right * (0.5 * right_share * projector.width_m) +
                               projector.up * (0.5 * up_share * projector.height_m);
    const bool is_near = light.kind == Source::Kind::place;
    const glm::dvec3 way = is_near ? light.vector - place_m : light.vector;
    lit += tree_.is_blocked(place_m, way, is_near ? 1.0 : std::numeric_limits<double>::infinity()) ? 0 : 1;
    ++all;
  };
  test(0.0, 0.0);
  for (int ring = 1; ring <= rings; ++ring) {
    const double radius = tested_share * ring / rings;
    for (int i = 0; i < places_a_ring; ++i) {
      // Rings are turned against each other, so that a straight edge does not meet places of all at once.
      const double angle_rad = 2.0 * std::numbers::pi * (i + ring / (rings + 1.0)) / places_a_ring;
      test(radius * std::cos(angle_rad), radius * std::sin(angle_rad));
    }
  }
  const double share = static_cast<double>(lit) / all;
  return share * share * (3.0 - 2.0 * share);
}

}  // namespace offing::highlights
