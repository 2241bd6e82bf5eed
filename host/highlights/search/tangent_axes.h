#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace offing::highlights {

/// Two unit vectors perpendicular to a normal and to one another: right x up = normal.
struct TangentAxes {
  glm::dvec3 right, up;
};

/// Some axes of the plane across a unit normal.
inline TangentAxes tangent_axes(const glm::dvec3& normal) {
  const glm::dvec3 other = std::abs(normal.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(other, normal));
  return {right, glm::cross(normal, right)};
}

}  // namespace offing::highlights
