#include "tests/mesh_tools/curvature/accuracy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace offing::test {
namespace {

using mesh_shapes::Diagonals;

double line_angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  const double cosine = std::min(1.0, std::abs(glm::dot(a, b)));
  return std::acos(cosine) * 180.0 / std::numbers::pi;
}

}  // namespace

CurvatureErrors errors_of(const VertexCurvatures& measured, const VertexCurvatures& truth) {
  CurvatureErrors sum;
  std::size_t directions = 0;
  const std::size_t vertices = truth.k_max_per_m.size();
  for (std::size_t i = 0; i < vertices; ++i) {
    const double k_max = truth.k_max_per_m[i], k_min = truth.k_min_per_m[i];
    const double largest = std::max(std::abs(k_max), std::abs(k_min));
    sum.curvature += 0.5 *
                     (std::abs(measured.k_max_per_m[i] - k_max) + std::abs(measured.k_min_per_m[i] - k_min)) /
                     largest;
    if (k_max - k_min < 0.1 * largest) continue;
    ++directions;
    sum.direction_deg += line_angle_deg(measured.e_max[i], truth.e_max[i]);
  }
  sum.curvature /= static_cast<double>(vertices);
  sum.direction_deg /= static_cast<double>(std::max<std::size_t>(directions, 1));
  return sum;
}

NamedShape jittered_ellipsoid() {
  return {"ellipsoid", mesh_shapes::make_ellipsoid({1.0, 0.75, 0.5}, 5, {.jitter = 0.25, .seed = 7})};
}

NamedShape jittered_torus() {
  return {"torus",
          mesh_shapes::make_torus(1.0, 0.4, {160, 64, Diagonals::random}, {.jitter = 0.3, .seed = 7})};
}

NamedShape noisy_torus() {
  return {"noisy torus", mesh_shapes::make_torus(1.0, 0.4, {160, 64, Diagonals::random},
                                                 {.jitter = 0.3, .normal_noise = 0.02, .seed = 7})};
}

NamedShape jittered_saddle() {
  return {"saddle",
          mesh_shapes::make_saddle(1.0, {100, 100, Diagonals::random}, {.jitter = 0.25, .seed = 7})};
}

std::vector<NamedShape> comparison_shapes() {
  return {jittered_ellipsoid(), jittered_torus(), noisy_torus(), jittered_saddle()};
}

}  // namespace offing::test
