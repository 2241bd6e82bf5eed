#include "host/highlights/projectors/pinned_point.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "host/highlights/search/tangent_axes.h"

namespace offing::highlights {

HighlightPoint pinned_point(const HighlightSurface& surface, const SurfacePlace& place) {
  HighlightPoint point;
  point.face = place.face;
  point.weights = place.weights;
  point.position_m = position_at(surface, place);
  point.normal = normal_at(surface, place);
  // Directions are lines: they are mixed as arrows of twice their angle, each as long as half the difference
  // of the curvatures there.
  const TangentAxes axes = tangent_axes(point.normal);
  const VertexCurvatures& curvatures = surface.curvatures();
  double mean = 0.0, twice_cosine = 0.0, twice_sine = 0.0;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t vertex = surface.mesh().faces[place.face][static_cast<std::size_t>(i)];
    const double k_max = curvatures.k_max_per_m[vertex], k_min = curvatures.k_min_per_m[vertex];
    const double x = glm::dot(curvatures.e_max[vertex], axes.right);
    const double y = glm::dot(curvatures.e_max[vertex], axes.up);
    const double deviation = place.weights[i] * 0.5 * (k_max - k_min) / std::max(x * x + y * y, 1e-12);
    mean += place.weights[i] * 0.5 * (k_max + k_min);
    twice_cosine += deviation * (x * x - y * y);
    twice_sine += deviation * 2.0 * x * y;
  }
  const double deviation = std::hypot(twice_cosine, twice_sine);
  const double angle_rad = 0.5 * std::atan2(twice_sine, twice_cosine);
  point.e_max = std::cos(angle_rad) * axes.right + std::sin(angle_rad) * axes.up;
  point.k_max_per_m = mean + deviation;
  point.k_min_per_m = mean - deviation;
  return point;
}

}  // namespace offing::highlights
