#include <cmath>
#include <numbers>

#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {
namespace {

// Of the length: those of a coaster.
constexpr double half_breadth = 0.085, draught = 0.075, freeboard = 0.055, sheer_rise = 0.035;
constexpr double camber = 0.06;        // of the half breadth
constexpr double stem_breadth = 0.02;  // of the half breadth, where the bow ends
constexpr double transom_breadth = 0.7;
// A quarter of each ring is deck.
constexpr double hull_share = 0.75;

/// A cross section at x = -1 (transom) ... 1 (stem), in half breadths and lengths.
struct ShipSection {
  double x, half_breadth, sheer, keel, fullness;
};

ShipSection ship_section_at(double x) {
  const double bow = std::max(0.0, x), stern = std::max(0.0, -x);
  const double narrowing =
      (1.0 - stem_breadth) * std::pow(bow, 2.6) + (1.0 - transom_breadth) * stern * stern * stern;
  return {.x = x,
          .half_breadth = half_breadth * (1.0 - narrowing),
          .sheer = freeboard + sheer_rise * x * x * (x > 0.0 ? 1.0 : 0.4),
          .keel = -draught * (1.0 - 0.15 * bow * bow - 0.6 * stern * stern * stern),
          // Round amidships, a V at the bow.
          .fullness = 0.45 + 0.5 * bow * bow + 0.15 * stern};
}

/// Around a section from its starboard sheer under the keel to the port sheer, and back over the deck; in
/// lengths.
glm::dvec3 ring_point(const ShipSection& section, double share) {
  // The stem rakes: it is longer above.
  const auto at = [&](double side, double height) {
    const double rake = section.x > 0.0 ? 0.05 * std::pow(section.x, 4.0) * (height - section.keel) /
                                              (section.sheer - section.keel)
                                        : 0.0;
    return glm::dvec3(0.5 * section.x + rake, height, side * section.half_breadth);
  };
  if (share < hull_share) {
    const double angle = std::numbers::pi * (share / hull_share - 0.5);
    const double side =
        std::copysign(std::pow(std::abs(std::sin(angle)), section.fullness), -std::sin(angle));
    return at(side, section.sheer + (section.keel - section.sheer) * std::cos(angle));
  }
  const double side = 2.0 * (share - hull_share) / (1.0 - hull_share) - 1.0;
  return at(side, section.sheer + camber * section.half_breadth * (1.0 - side * side));
}

}  // namespace

Shape make_ship(double length_m, const Grid& grid) {
  require_shape_size("length", length_m);
  require_grid(grid, 4);
  return {.mesh = lofted(grid,
                         [&](int ring, int point) {
                           // Sections stand closer at both ends.
                           const ShipSection section =
                               ship_section_at(-std::cos(std::numbers::pi * ring / grid.u_cells));
                           return length_m * ring_point(section, static_cast<double>(point) / grid.v_cells);
                         }),
          .truth = {}};
}

}  // namespace offing::mesh_shapes
