#pragma once

#include <string_view>

#include "host/io/meshes/mesh_file.h"

namespace offing::meshes {

/// A Wavefront OBJ. Vertices are those of its `v` lines, in their order; faces (`f`, `fo`) take the first
/// index of each corner, so that seams of textures (`vt`) split nothing. Indices count from 1 on, or from the
/// last vertex back where they are negative; a face may come before its vertices. Normals (`vn`) are kept if
/// all corners of each vertex have the same one. Points, lines and free-form curves and surfaces are left out
/// and counted; names, groups, materials and other attributes are passed over.
///
/// Strict and ours, because tinyobjloader 2 reads numbers that are none as 0, rounds others, and drops faces
/// of fewer than three corners and polygons without an area in silence.
///
/// Throws Error(bad_input) with the line for what is no OBJ, and as PolygonSoup::finish().
MeshFile parse_obj(std::string_view text, std::string_view file_name);

}  // namespace offing::meshes
