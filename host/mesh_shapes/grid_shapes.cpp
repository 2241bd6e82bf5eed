// Shapes over a grid of two parameters.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Vertex (u, v) of a grid, moved within its cell, in cells.
struct GridPlace {
  double u, v;
};

GridPlace jittered(int u, int v, std::size_t index, const Roughness& roughness) {
  if (!(roughness.jitter > 0.0)) return {static_cast<double>(u), static_cast<double>(v)};
  const ShapeRandom random(roughness.seed, index);
  return {u + roughness.jitter * random.within_one(0), v + roughness.jitter * random.within_one(1)};
}

/// A closed grid of points of a surface, from angles along u and v.
template <typename PointAt>
std::vector<SurfacePoint> closed_grid(const Grid& grid, const Roughness& roughness, const PointAt& point_at) {
  std::vector<SurfacePoint> points;
  for (int u = 0; u < grid.u_cells; ++u) {
    for (int v = 0; v < grid.v_cells; ++v) {
      const GridPlace place = jittered(u, v, points.size(), roughness);
      points.push_back(point_at(turn * place.u / grid.u_cells, turn * place.v / grid.v_cells));
    }
  }
  return points;
}

/// The place of a tube of radius r about a curve: n across the curve, and how the curve bends, as its second
/// derivative by arc length. Around the tube the curvature is 1 / r; along the tangent, dn = -(bend n) T ds
/// and dP = (1 - r bend n) T ds.
SurfacePoint tube_point(const glm::dvec3& middle_m, const glm::dvec3& tangent, const glm::dvec3& bend_per_m,
                        const glm::dvec3& normal, double tube_radius_m) {
  const double toward = glm::dot(bend_per_m, normal);
  const double around_per_m = 1.0 / tube_radius_m, along_per_m = -toward / (1.0 - tube_radius_m * toward);
  // Along is never the larger: it grows toward 1 / r as the curve bends ever more.
  return {.position_m = middle_m + tube_radius_m * normal,
          .normal = normal,
          .k_max_per_m = around_per_m,
          .k_min_per_m = along_per_m,
          .e_max = glm::cross(tangent, normal),
          .e_min = tangent};
}

/// The torus knot's middle and its first two derivatives by the parameter.
struct KnotCurve {
  glm::dvec3 middle_m, first_m, second_m, torus_normal;
};

KnotCurve knot_curve(const TorusKnot& knot, double t) {
  const double p = knot.around, q = knot.through;
  const double cp = std::cos(p * t), sp = std::sin(p * t), cq = std::cos(q * t), sq = std::sin(q * t);
  const double radius_m = knot.radius_m + knot.winding_m * cq;
  const double radius_1 = -q * knot.winding_m * sq, radius_2 = -q * q * knot.winding_m * cq;
  return {.middle_m = {radius_m * cp, radius_m * sp, knot.winding_m * sq},
          .first_m = {radius_1 * cp - p * radius_m * sp, radius_1 * sp + p * radius_m * cp,
                      q * knot.winding_m * cq},
          .second_m = {radius_2 * cp - 2.0 * p * radius_1 * sp - p * p * radius_m * cp,
                       radius_2 * sp + 2.0 * p * radius_1 * cp - p * p * radius_m * sp,
                       -q * q * knot.winding_m * sq},
          .torus_normal = {cq * cp, cq * sp, sq}};
}

}  // namespace

Shape make_torus(double radius_m, double tube_radius_m, const Grid& grid, const Roughness& roughness) {
  require_shape_size("radius", radius_m);
  require_shape_value("tube radius", tube_radius_m, 1e-6 * radius_m, (1.0 - 1e-6) * radius_m);
  require_grid(grid, 3);
  require_roughness(roughness);
  const auto points = closed_grid(grid, roughness, [&](double u, double v) {
    const glm::dvec3 out{std::cos(u), std::sin(u), 0.0};
    const glm::dvec3 normal = std::cos(v) * out + glm::dvec3(0.0, 0.0, std::sin(v));
    return tube_point(radius_m * out, {-out.y, out.x, 0.0}, -out / radius_m, normal, tube_radius_m);
  });
  const double edge_m = turn * tube_radius_m / grid.v_cells;
  return shape_of(points, grid_faces(grid, GridEnds::u_and_v_closed, roughness.seed),
                  roughness.normal_noise * edge_m, roughness.seed);
}

Shape make_torus_knot(const TorusKnot& knot, const Grid& grid, const Roughness& roughness) {
  require_shape_value("turns around", knot.around, 1, most_windings);
  require_shape_value("turns through", knot.through, 1, most_windings);
  require_shape_size("radius", knot.radius_m);
  require_shape_value("winding radius", knot.winding_m, 1e-6 * knot.radius_m, (1.0 - 1e-6) * knot.radius_m);
  require_shape_value("tube radius", knot.tube_radius_m, 1e-6 * knot.radius_m, knot.radius_m);
  require_grid(grid, 3);
  require_roughness(roughness);
  const auto points = closed_grid(grid, roughness, [&](double u, double v) {
    const KnotCurve curve = knot_curve(knot, u);
    const double speed_m = glm::length(curve.first_m);
    const glm::dvec3 tangent = curve.first_m / speed_m;
    const glm::dvec3 bend_per_m =
        (curve.second_m - glm::dot(curve.second_m, tangent) * tangent) / (speed_m * speed_m);
    if (!(glm::length(bend_per_m) * knot.tube_radius_m < 1.0)) {
      throw Error(
          ErrorKind::bad_usage,
          fmt::format(
              "torus knot: expected a tube radius below {:g} m, at which it bends onto itself, found {:g} m",
              1.0 / glm::length(bend_per_m), knot.tube_radius_m),
          "choose a thinner tube or a larger radius");
    }
    // The curve lies on a torus, whose normal stands across it and comes back to itself.
    const glm::dvec3 binormal = glm::cross(curve.torus_normal, tangent);
    return tube_point(curve.middle_m, tangent, bend_per_m,
                      std::cos(v) * curve.torus_normal + std::sin(v) * binormal, knot.tube_radius_m);
  });
  const double edge_m = turn * knot.tube_radius_m / grid.v_cells;
  return shape_of(points, grid_faces(grid, GridEnds::u_and_v_closed, roughness.seed),
                  roughness.normal_noise * edge_m, roughness.seed);
}

Shape make_saddle(double half_width_m, const Grid& grid, const Roughness& roughness) {
  require_shape_size("half width", half_width_m);
  require_grid(grid, 1);
  require_roughness(roughness);
  // Vertices of the border stay on it, and its corners where they are.
  const auto across = [&](double place, int index, int cells) {
    return 2.0 * (index == 0 || index == cells ? index : place) / cells - 1.0;
  };
  std::vector<SurfacePoint> points;
  for (int u = 0; u <= grid.u_cells; ++u) {
    for (int v = 0; v <= grid.v_cells; ++v) {
      const GridPlace place = jittered(u, v, points.size(), roughness);
      const double x = across(place.u, u, grid.u_cells), y = across(place.v, v, grid.v_cells);
      // z - f(x, y), in half widths.
      SurfacePoint point =
          level_set_point({x, y, 0.75 * x * x - 0.4 * y * y + 0.1 * x * x * x},
                          {-1.5 * x - 0.3 * x * x, 0.8 * y, 1.0}, {.xx = -1.5 - 0.6 * x, .yy = 0.8});
      point.position_m *= half_width_m;
      point.k_max_per_m /= half_width_m;
      point.k_min_per_m /= half_width_m;
      points.push_back(point);
    }
  }
  const double edge_m = 2.0 * half_width_m / std::max(grid.u_cells, grid.v_cells);
  return shape_of(points, grid_faces(grid, GridEnds::open, roughness.seed), roughness.normal_noise * edge_m,
                  roughness.seed);
}

}  // namespace offing::mesh_shapes
