#include "host/highlights/search/triangle_point.h"

#include <algorithm>
#include <array>
#include <limits>

#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

/// How far along from a to b the point of the edge nearest to p is: 0 ... 1.
double share_of_edge(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  return length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
}

}  // namespace

glm::dvec3 nearest_weights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  if (glm::dot(normal, normal) > 0.0) {
    const auto opposite = [&](const glm::dvec3& from, const glm::dvec3& to) {
      return glm::dot(glm::cross(to - from, p - from), normal);
    };
    const glm::dvec3 weights(opposite(b, c), opposite(c, a), opposite(a, b));
    if (std::min({weights.x, weights.y, weights.z}) >= 0.0)
      return weights / (weights.x + weights.y + weights.z);
  }
  const std::array corners{a, b, c};
  glm::dvec3 nearest;
  double least_m2 = std::numeric_limits<double>::infinity();
  for (int from = 0; from < 3; ++from) {
    const int to = (from + 1) % 3;
    const double share = share_of_edge(p, corners[from], corners[to]);
    const glm::dvec3 way = corners[from] + share * (corners[to] - corners[from]) - p;
    if (glm::dot(way, way) >= least_m2) continue;
    least_m2 = glm::dot(way, way);
    nearest = glm::dvec3(0.0);
    nearest[from] = 1.0 - share;
    nearest[to] = share;
  }
  return nearest;
}

double squared_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 weights = nearest_weights(p, a, b, c);
  const glm::dvec3 way = weights.x * (a - p) + weights.y * (b - p) + weights.z * (c - p);
  return glm::dot(way, way);
}

}  // namespace offing::highlights
