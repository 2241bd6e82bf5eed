#pragma once

#include <glm/vec3.hpp>

namespace offing::highlights {

/// Shares, 0 ... 1 with the sum 1, of a triangle's corners in its point nearest to p; triangles without area
/// count as their edges.
glm::dvec3 nearest_weights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c);

/// Square of the distance from p to the triangle.
double squared_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace offing::highlights
