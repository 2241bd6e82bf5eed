#pragma once

#include <array>
#include <cstdint>
#include <functional>
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

/// Where the vertices of a mesh that deforms are at one time; its faces stay.
struct MeshForm {
  std::vector<glm::dvec3> positions_m;  ///< [vertices], finite
  std::vector<glm::dvec3> normals;      ///< [vertices], of any length; empty: those of the faces
};

/// How a mesh deforms. It holds its first form before time 0, and its last one from end_s on.
struct Deformation {
  std::function<MeshForm(double time_s)> form_at;  ///< the same for the same time; none: it never deforms
  double end_s = 0.0;

  explicit operator bool() const { return form_at != nullptr; }
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
