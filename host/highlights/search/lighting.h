#pragma once

#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "kernels/shared/highlights.h"

namespace offing::highlights {

/// An eye or a light: at a place, or so far away that only the direction to it counts.
struct Source {
  /// What the vector is.
  enum class Kind { direction, place };
  Kind kind = Kind::direction;
  glm::dvec3 vector{0.0, 1.0, 0.0};  ///< toward it, of any length above 0; or where it is, in metres
};

/// What highlights depend on besides the surface. A parallel projection is an eye in a direction.
struct Lighting {
  Source eye;
  std::vector<Source> lights;  ///< any number
};

/// Where a mesh is: world = rotation * mesh + translation_m. The rotation is orthonormal.
struct RigidMotion {
  glm::dmat3 rotation{1.0};
  glm::dvec3 translation_m{0.0};
};

/// The same eye and lights, in the axes of a mesh that stands there.
Lighting in_mesh_axes(const Lighting& world, const RigidMotion& mesh);

/// The half vector H = (L + V) / |L + V| of a light at a place (Blinn; H3 of docs/sources.md). A zero vector
/// exactly between eye and light.
glm::dvec3 half_vector(const Source& eye, const Source& light, const glm::dvec3& place_m);

/// A light with the eye as the kernels read it, relative to `middle_m`. Throws Error(bad_input) that names
/// the source if its vector is not finite, or a direction is zero.
HighlightLight packed_light(const Source& eye, const Source& light, const glm::dvec3& middle_m);

}  // namespace offing::highlights
