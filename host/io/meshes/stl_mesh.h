#pragma once

#include <string_view>

#include "host/io/meshes/mesh_file.h"

namespace offing::meshes {

/// An STL in text or binary. It has no vertices: corners at exactly the same place become one, numbered as
/// they first come. Normals of facets follow from their corners and are passed over, names and attributes as
/// well. A binary file is known by its length, which must be what its count of facets asks for: many begin
/// with the word solid, too.
///
/// Strict and ours: libraries without GPL that read both kinds allocate what the count claims.
///
/// Throws Error(bad_input) with line or facet for what is no STL, and as PolygonSoup::finish().
MeshFile parse_stl(std::string_view bytes, std::string_view file_name);

}  // namespace offing::meshes
