#include "host/highlights/projectors/projector.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "host/base/parameter_check.h"

namespace offing::highlights {

HighlightSize default_size(const HighlightSurface& surface) {
  return {.cap_radius_m = std::max(3.0 * surface.mean_edge_m(), 1e-9)};
}

double width_m(double curvature_per_m, const HighlightSize& size) {
  const double sine = std::sqrt(1.0 - size.threshold * size.threshold);
  const double flat = sine / size.cap_radius_m;  // below this curvature the cap is narrower
  return 2.0 * sine / std::max(std::abs(curvature_per_m), flat);
}

double curvature_along(const HighlightPoint& point, const glm::dvec3& direction) {
  const double cosine = glm::dot(direction, point.e_max);
  return point.k_min_per_m + (point.k_max_per_m - point.k_min_per_m) * cosine * cosine;
}

Projector projector_at(const HighlightPoint& point, const HighlightSize& size) {
  require_within("highlights.threshold", size.threshold, 0.0, 1.0 - 1e-9);
  require_within("highlights.cap_radius_m", size.cap_radius_m, 1e-12, 1e12);
  return {.centre_m = point.position_m,
          .right = point.e_max,
          .up = glm::cross(point.normal, point.e_max),
          .normal = point.normal,
          .width_m = width_m(point.k_max_per_m, size),
          .height_m = width_m(point.k_min_per_m, size)};
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
