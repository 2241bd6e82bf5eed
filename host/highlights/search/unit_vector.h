#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace offing {

/// The vector at length 1; 0 where it has no length.
inline glm::dvec3 unit_or_zero(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

}  // namespace offing
