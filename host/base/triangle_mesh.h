#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace offing {

/// Three vertices by index, anticlockwise seen from outside.
using TriangleIndices = std::array<std::uint32_t, 3>;

/// Triangles of a surface. Neighbourhood is nowhere assumed to be that of a manifold: an edge may have any
/// number of faces, a vertex any number of fans, and each face of a file is here.
struct TriangleMesh {
  std::vector<glm::dvec3> positions_m;  ///< [vertices], finite, in the order of the source
  std::vector<glm::dvec3> normals;      ///< [vertices] unit vectors; empty if the source has none
  std::vector<TriangleIndices> faces;   ///< [faces], each index below the count of vertices
};

/// What bends a surface at its vertices. Curvatures are in 1/m and positive where the surface is convex: a
/// sphere of radius r with its normals outward has k_max = k_min = 1/r. All arrays are [vertices].
struct VertexCurvatures {
  std::vector<double> k_max_per_m, k_min_per_m;  ///< k_max >= k_min
  /// Unit directions of k_max and k_min, tangent to the surface and perpendicular to one another. They are
  /// lines: their signs mean nothing, but e_max x e_min is the outward normal. Zero vectors where a vertex
  /// has no faces with an area.
  std::vector<glm::dvec3> e_max, e_min;
  std::vector<double> area_m2;  ///< share of the surface: a third of the faces around
  /// 0 ... 1: how far the directions can be trusted. 0 where none is preferred (umbilics) and where the
  /// vertex has no surface around it; lower at borders.
  std::vector<double> confidence;
};

}  // namespace offing
