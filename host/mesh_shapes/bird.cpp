#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {
namespace {

/// From 0 at `from` to 1 at `to`, smooth at both.
double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// An ellipse along x and y, in spans.
struct Section {
  double front, back, height, half_thickness;
};

/// At -1 (port tip) ... 1 (starboard tip): wings that are swept back from the wrist, a head with its beak
/// before them and a tail behind.
Section section_at(double side) {
  const double out = std::abs(side);
  const double leading = 0.09 + 0.22 * out - 0.50 * out * out,
               trailing = -0.09 + 0.10 * out - 0.22 * out * out;
  const double head = 0.21 * std::sqrt(std::max(0.0, 1.0 - std::pow(out / 0.11, 2.0)));
  const double beak = 0.06 * std::max(0.0, 1.0 - out / 0.06);
  const double tail = 0.25 * smooth_step(0.19, 0.09, out);
  return {.front = leading + head + beak,
          .back = trailing - tail,
          .height = 0.22 * out * (1.2 - 0.5 * out),
          .half_thickness = 0.008 + 0.020 * (1.0 - out) + 0.045 * std::exp(-std::pow(out / 0.13, 2.0))};
}

}  // namespace

Shape make_bird(double span_m, const Grid& grid) {
  require_shape_size("span", span_m);
  require_grid(grid, 4);
  const auto at = [&](int ring, int point) {
    // Sections stand closer about the body.
    const double share = 2.0 * ring / grid.u_cells - 1.0,
                 side = std::copysign(std::pow(std::abs(share), 1.7), share);
    const Section section = section_at(side);
    const double angle = 2.0 * std::numbers::pi * point / grid.v_cells;
    const double middle = 0.5 * (section.front + section.back), half = 0.5 * (section.front - section.back);
    return span_m * glm::dvec3(middle + half * std::cos(angle),
                               section.height + section.half_thickness * std::sin(angle), 0.5 * side);
  };
  return {.mesh = lofted(grid, at), .truth = {}};
}

}  // namespace offing::mesh_shapes
