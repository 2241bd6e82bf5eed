#pragma once

#include <cstddef>

#include "host/base/triangle_mesh.h"
#include "host/base/work.h"

namespace offing::mesh_tools {

/// Which way closed components face in the end.
enum class Facing { as_most_faces, outward };

struct RepairSettings {
  int most_hole_edges = 16;  ///< loops of more edges stay open, or around half their component's area
  Facing facing = Facing::as_most_faces;
};

/// What a repair has changed, in the order of its steps.
struct RepairChanges {
  std::size_t merged_vertices = 0;           ///< on borders, at exactly one place: seams closed
  std::size_t removed_repeating_faces = 0;   ///< that name a vertex twice
  std::size_t removed_duplicate_faces = 0;   ///< of the same three vertices as an earlier one
  std::size_t turned_faces = 0;              ///< that lie the other way in the end
  std::size_t split_vertices = 0;            ///< added where an edge had three faces, a vertex two fans, or a
                                             ///< one-sided surface had to be cut
  std::size_t removed_degenerate_faces = 0;  ///< without an area; neighbours close the gap
  std::size_t collapsed_vertices = 0;        ///< that went with them
  std::size_t filled_holes = 0;
  std::size_t added_faces = 0;       ///< in holes
  std::size_t open_loops = 0;        ///< left open
  std::size_t removed_vertices = 0;  ///< of no face
};

/// Makes an oriented manifold of any triangles: seams are closed, faces that are none and repeated ones
/// removed, faces turned so that neighbours agree, edges of three faces and vertices of two fans taken apart,
/// faces without an area removed, small holes filled. Positions of vertices that stay do not change, nor does
/// their order; normals are dropped. Self-intersections stay. Throws Error(cancelled) when asked to stop,
/// Error(bad_input) if no face is left.
RepairChanges repair(TriangleMesh& mesh, const RepairSettings& settings, const CancelToken& cancel);

}  // namespace offing::mesh_tools
