// Shapes of circles one above the other: cylinder and cone.
#include <cmath>
#include <numbers>
#include <utility>

#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {
namespace {

/// A point of the circle at this height; they follow one another from +x toward -z, so that faces turn
/// outward.
glm::dvec3 circle_point(double radius_m, double y_m, int point, const Grid& grid) {
  const double angle = -2.0 * std::numbers::pi * point / grid.v_cells;
  return {radius_m * std::cos(angle), y_m, radius_m * std::sin(angle)};
}

void require_sizes(double radius_m, double height_m, const Grid& grid) {
  require_shape_size("radius", radius_m);
  require_shape_size("height", height_m);
  require_grid(grid, 3);
}

}  // namespace

Shape make_cylinder(double radius_m, double height_m, const Grid& grid) {
  require_sizes(radius_m, height_m, grid);
  return {.mesh = lofted(grid,
                         [&](int ring, int point) {
                           const double share = static_cast<double>(ring) / grid.u_cells;
                           return circle_point(radius_m, height_m * (share - 0.5), point, grid);
                         }),
          .truth = {}};
}

Shape make_cone(double radius_m, double height_m, const Grid& grid) {
  require_sizes(radius_m, height_m, grid);
  // The last cells are the fan about the apex.
  TriangleMesh mesh = lofted({grid.u_cells - 1, grid.v_cells}, [&](int ring, int point) {
    const double share = static_cast<double>(ring) / grid.u_cells;
    return circle_point(radius_m * (1.0 - share), height_m * (share - 0.5), point, grid);
  });
  mesh.positions_m.back() = {0.0, 0.5 * height_m, 0.0};
  return {.mesh = std::move(mesh), .truth = {}};
}

}  // namespace offing::mesh_shapes
