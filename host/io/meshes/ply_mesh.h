#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "host/io/meshes/mesh_file.h"

namespace offing::meshes {

/// A PLY and columns of its vertices.
struct PlyMesh {
  MeshFile file;
  std::vector<std::vector<double>>
      columns;  ///< [wanted][vertices]; empty where the file has no such property
};

/// A PLY in text, binary little-endian or big-endian, with numbers of any type: `vertex` with x y z and
/// perhaps nx ny nz, `face` with a list vertex_indices or vertex_index, or `tristrips` with one of
/// vertex_indices, where -1 ends a strip. `wanted` names other properties of vertices to keep; those that are
/// not wanted and other elements are passed over, edges counted as left out.
///
/// Strict and ours: CGAL's reader is told the properties beforehand, OpenMesh's drops faces, and both
/// allocate what a header claims.
///
/// Throws Error(bad_input) for what is no PLY or ends early, naming line or element, and as
/// PolygonSoup::finish().
PlyMesh parse_ply(std::string_view text, std::string_view file_name,
                  std::span<const std::string_view> wanted = {});

}  // namespace offing::meshes
