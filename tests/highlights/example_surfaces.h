#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::test {

/// A mesh with the normals and curvatures of the surface that it samples.
struct ExampleSurface {
  TriangleMesh mesh;
  VertexCurvatures curvatures;
  int genus = 0;
};

/// x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1, an octahedron whose faces were cut in four `levels` times.
ExampleSurface ellipsoid(int levels, glm::dvec3 half_axes_m);

/// About z, in a grid of vertices.
ExampleSurface torus(int around, int across, double large_radius_m, double small_radius_m);

/// A sphere of radius 1 + 0.15 sin 8x sin 8y sin 8z: humps, hollows and saddles.
ExampleSurface bumpy_sphere(int levels);

/// The same surface elsewhere.
ExampleSurface moved(const ExampleSurface& surface, const glm::dmat3& rotation, const glm::dvec3& way_m);

/// Random vectors and rotations from a counter: the same for a seed everywhere.
class RandomVectors {
 public:
  explicit RandomVectors(std::uint64_t seed) : state_(seed) {}
  double uniform();        ///< 0 ... 1
  glm::dvec3 direction();  ///< even over the unit sphere
  glm::dmat3 rotation();

 private:
  std::uint64_t state_;
};

}  // namespace offing::test
