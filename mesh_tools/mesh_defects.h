#pragma once

#include <cstddef>
#include <string_view>

#include "host/base/triangle_mesh.h"
#include "host/base/work.h"

namespace offing::mesh_tools {

/// What is to know about a mesh before it is used. Counted by index, so that no defect hides another: an edge
/// may have any number of faces, a vertex any number of fans. Faces that name a vertex twice have no part in
/// edges, fans and loops.
struct MeshDefects {
  std::size_t vertices = 0, faces = 0;
  std::size_t components = 0;             ///< sets of faces joined by vertices
  std::size_t boundary_edges = 0;         ///< edges of one face
  std::size_t boundary_loops = 0;         ///< sets of boundary edges joined by vertices
  std::size_t non_manifold_edges = 0;     ///< edges of three faces or more
  std::size_t non_manifold_vertices = 0;  ///< vertices whose faces are two fans or more, joined by no edge
  std::size_t degenerate_faces = 0;       ///< without an area: corners at one place or on one line, exactly
  std::size_t duplicate_faces = 0;        ///< of the same three vertices as an earlier face
  std::size_t isolated_vertices = 0;      ///< of no face
  std::size_t turned_edges = 0;           ///< edges of two faces that run along it the same way
  bool orientable = true;                 ///< whether turning faces can leave no such edge
  std::size_t repeating_faces = 0;        ///< which name a vertex twice
  std::size_t self_intersections = 0;     ///< pairs of faces that meet elsewhere than in what they share
};

/// All but what needs geometry: degenerate_faces and self_intersections stay 0.
MeshDefects find_index_defects(const TriangleMesh& mesh);

/// Throws Error(cancelled) when asked to stop.
MeshDefects find_defects(const TriangleMesh& mesh, const CancelToken& cancel);

/// What half-edges can hold. Throws Error(bad_input) that names the file, and `offing-mesh repair` as the
/// fix, for an edge of three faces, a vertex of two fans, neighbours that disagree, a face that names a
/// vertex twice.
void require_manifold(const TriangleMesh& mesh, std::string_view file_name);

}  // namespace offing::mesh_tools
