#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"
#include "mesh_tools/curvature/unit_mesh.h"

namespace offing::mesh_tools {

enum class CurvatureMethod {
  fit,           ///< a quadric fitted to the vertices within a ball, over chords: the most accurate
  tensor,        ///< angles of edges within a ball, rim edges by half (H1, H2 of docs/sources.md)
  tensor_exact,  ///< the same, edges and triangles clipped to the ball
  paper,         ///< H1 as printed, for comparison: its bias does not go away with finer meshes
  diffused,      ///< angles of the edges around each vertex, averaged with neighbours: the fastest
  jet,           ///< CGAL's fit of a quadratic through two rings of neighbours
};

/// Whether concave edges bend the other way (as they do) or count as convex ones do (as printed).
enum class EdgeAngles { with_sign, unsigned_as_printed };

struct CurvatureOptions {
  CurvatureMethod method = CurvatureMethod::fit;
  /// Of the ball, in mean edge lengths of the mesh, 0.01 ... 100; by default 3.5 for fit (6 to 14 for a noisy
  /// mesh), else 3.
  std::optional<double> radius_edges{};
  std::optional<double> radius_m{};           ///< of the ball; overrides radius_edges
  int rounds = 3;                             ///< of averaging, of the method diffused, 0 ... 1000
  EdgeAngles angles = EdgeAngles::with_sign;  ///< of the method paper
  int threads = 0;                            ///< 0: as many as there are processors. Changes no result
};

struct CurvatureResult {
  VertexCurvatures curvatures;
  /// [vertices] unit, e_max x e_min; (0, 0, 1) where a vertex has no surface, as files want one of unit
  /// length.
  std::vector<glm::dvec3> normals;
};

/// Curvatures at all vertices of a mesh, 1:1 in its order. Vertices at exactly one position are one vertex of
/// the surface, as at seams of texture coordinates, and get the same. Whatever the faces are, nothing is NaN
/// or infinite: what has no surface around it has curvature 0 and confidence 0; edges of other than two faces
/// do not bend. Throws Error(bad_usage) for options out of range, Error(bad_input) for faces that name no
/// vertex, and for positions that are not finite or farther than 1e100 m apart.
CurvatureResult vertex_curvatures(const TriangleMesh& mesh, const CurvatureOptions& options = {});

/// The same of a mesh whose neighbours are known already.
CurvatureResult vertex_curvatures(const UnitMesh& mesh, const CurvatureOptions& options = {});

/// In the order of the enumeration.
inline constexpr std::array<std::string_view, 6> curvature_method_names{"fit",   "tensor",   "tensor-exact",
                                                                        "paper", "diffused", "jet"};
constexpr std::string_view name_of(CurvatureMethod method) {
  return curvature_method_names[static_cast<std::size_t>(method)];
}

}  // namespace offing::mesh_tools
