#include "tests/highlights/reference_search.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace offing::test {
namespace {

using highlights::HighlightPoint;
using highlights::Source;

glm::dvec3 mix(const std::vector<glm::dvec3>& values, const TriangleIndices& face,
               const glm::dvec3& weights) {
  return weights.x * values[face[0]] + weights.y * values[face[1]] + weights.z * values[face[2]];
}

}  // namespace

std::vector<HighlightPoint> reference_points(const TriangleMesh& mesh, const Source& eye, const Source& light,
                                             double slack) {
  std::vector<HighlightPoint> points;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleIndices& face = mesh.faces[f];
    const glm::dmat3 normals(mesh.normals[face[0]], mesh.normals[face[1]], mesh.normals[face[2]]);
    const double determinant = glm::determinant(normals);
    if (determinant == 0.0) continue;
    // b for the H of the place of the last b, until both agree.
    glm::dvec3 weights(1.0 / 3.0);
    bool is_usable = true;
    for (int step = 0; step < 40 && is_usable; ++step) {
      const glm::dvec3 h = half_vector(eye, light, mix(mesh.positions_m, face, weights));
      const glm::dvec3 solution = glm::inverse(normals) * h;
      const double total = solution.x + solution.y + solution.z;
      // N = lambda H with lambda = 1 / total, which must be above 0.
      is_usable = total > 0.0 && glm::length(solution / total) < 1e3;
      if (is_usable) weights = solution / total;
    }
    if (!is_usable || std::min({weights.x, weights.y, weights.z}) < -slack) continue;
    HighlightPoint point;
    point.face = f;
    point.orientation = determinant > 0.0 ? 1 : -1;
    point.weights = weights;
    point.position_m = mix(mesh.positions_m, face, weights);
    point.normal = glm::normalize(mix(mesh.normals, face, weights));
    points.push_back(point);
  }
  return points;
}

}  // namespace offing::test
