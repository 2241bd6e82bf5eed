#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {
namespace {

// Of the length: those of a rowing boat.
constexpr double half_breadth = 0.16, draught = 0.06, freeboard = 0.09, sheer_rise = 0.05;
constexpr double wall = 0.013, floor_rise = 0.03;  // how far the inner skin is within the outer one
// Of the half length: where the decks at both ends begin, and where they have reached the sheer.
constexpr double hollow_end = 0.72, deck_begin = 0.84;
constexpr double stem_breadth = 0.04, transom_breadth = 0.6;  // of the half breadth
constexpr double fullness = 0.55;
// Half of each ring is the outer skin.
constexpr double outer_share = 0.5;

/// A cross section at x = -1 (transom) ... 1 (stem), in lengths.
struct BoatSection {
  double half_breadth, sheer, keel;
};

BoatSection boat_section_at(double x) {
  const double bow = std::max(0.0, x), stern = std::max(0.0, -x);
  const double narrowing =
      (1.0 - stem_breadth) * std::pow(bow, 2.2) + (1.0 - transom_breadth) * stern * stern * stern;
  return {.half_breadth = half_breadth * (1.0 - narrowing),
          .sheer = freeboard + sheer_rise * x * x,
          .keel = -draught * (1.0 - 0.5 * bow * bow - 0.4 * stern * stern)};
}

/// Down one side and up the other: share 0 ... 1 from starboard to port.
glm::dvec3 skin_point(double x, const BoatSection& section, double share) {
  const double angle = std::numbers::pi * (share - 0.5);
  const double side = std::copysign(std::pow(std::abs(std::sin(angle)), fullness), -std::sin(angle));
  return {0.5 * x, section.sheer + (section.keel - section.sheer) * std::cos(angle),
          side * section.half_breadth};
}

/// What the boat holds at this section: nothing at its ends, where it has decks.
BoatSection hollow_of(const BoatSection& section, double x) {
  const double rest = std::clamp((std::abs(x) - hollow_end) / (deck_begin - hollow_end), 0.0, 1.0);
  return {.half_breadth = section.half_breadth - std::min(wall, 0.5 * section.half_breadth),
          .sheer = section.sheer,
          .keel = std::lerp(section.keel + floor_rise, section.sheer, rest)};
}

}  // namespace

Shape make_boat(double length_m, const Grid& grid) {
  require_shape_size("length", length_m);
  require_grid(grid, 8);
  return {.mesh = lofted(grid,
                         [&](int ring, int point) {
                           const double x = -std::cos(std::numbers::pi * ring / grid.u_cells);
                           const BoatSection section = boat_section_at(x);
                           const double share = static_cast<double>(point) / grid.v_cells;
                           if (share < outer_share) {
                             return length_m * skin_point(x, section, share / outer_share);
                           }
                           return length_m * skin_point(x, hollow_of(section, x),
                                                        1.0 - (share - outer_share) / (1.0 - outer_share));
                         }),
          .truth = {}};
}

}  // namespace offing::mesh_shapes
