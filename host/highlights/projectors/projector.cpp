#include "host/highlights/projectors/projector.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "host/base/parameter_check.h"
#include "host/highlights/search/surface_walk.h"

namespace offing::highlights {

namespace {

// Nothing on a mesh is seen as one highlight if it is wider than half the diagonal.
constexpr double widest_half_share = 0.25;
// A surface that has turned by more is seen from the side: 80 degrees.
constexpr double least_cosine = 0.17;

}  // namespace

void require_valid(const HighlightSize& size) {
  require_within("highlights.threshold", size.threshold, 0.0, 1.0 - 1e-9);
  require_within("highlights.cap_radius_m", size.cap_radius_m, 0.0, 1e12);
}

HighlightSize with_cap(const HighlightSize& size, const HighlightSurface& surface) {
  HighlightSize result = size;
  if (size.cap_radius_m == 0.0 && size.flat_limit == FlatLimit::mean_edges)
    result.cap_radius_m = std::max(3.0 * surface.mean_edge_m(), 1e-9);
  return result;
}

double width_m(double curvature_per_m, const HighlightSize& size) {
  const double sine = std::sqrt(1.0 - size.threshold * size.threshold);
  // Below this curvature the cap is narrower.
  const double flat = size.cap_radius_m > 0.0 ? sine / size.cap_radius_m : 0.0;
  return 2.0 * sine / std::max(std::abs(curvature_per_m), flat);
}

double width_along(const HighlightSurface& surface, const HighlightPoint& point, const glm::dvec3& direction,
                   const HighlightSize& size) {
  const double width = width_m(curvature_along(point, direction), size);
  if (size.cap_radius_m > 0.0) return width;
  const double most_m = std::min(0.5 * width, widest_half_share * surface.diagonal_m());
  const double cosine = std::max(2.0 * size.threshold * size.threshold - 1.0, least_cosine);
  const SurfacePlace place{point.face, point.weights};
  return facing_length_m(surface, place, direction, cosine, most_m) +
         facing_length_m(surface, place, -direction, cosine, most_m);
}

double curvature_along(const HighlightPoint& point, const glm::dvec3& direction) {
  const double cosine = glm::dot(direction, point.e_max);
  return point.k_min_per_m + (point.k_max_per_m - point.k_min_per_m) * cosine * cosine;
}

Projector projector_at(const HighlightSurface& surface, const HighlightPoint& point,
                       const HighlightSize& size) {
  require_valid(size);
  const glm::dvec3 up = glm::cross(point.normal, point.e_max);
  return {.centre_m = point.position_m,
          .right = point.e_max,
          .up = up,
          .normal = point.normal,
          .width_m = width_along(surface, point, point.e_max, size),
          .height_m = width_along(surface, point, up, size)};
}

glm::dmat4 projection_of(const Projector& projector) {
  const double depth_m = std::max(projector.width_m, projector.height_m);
  const glm::dvec3 rows[3] = {projector.right * (2.0 / projector.width_m),
                              projector.up * (2.0 / projector.height_m), projector.normal * (2.0 / depth_m)};
  glm::dmat4 matrix(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix[column][row] = rows[row][column];
    matrix[3][row] = -glm::dot(rows[row], projector.centre_m);
  }
  return matrix;
}

}  // namespace offing::highlights
