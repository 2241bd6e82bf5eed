#pragma once

#include <string_view>

#include "host/io/meshes/mesh_file.h"

namespace offing::meshes {

/// An OFF of Geomview in text: OFF or no keyword, with N normals and C colours (NOFF, COFF, CNOFF), ST
/// texture coordinates; colours and texture coordinates are left out and counted. One vertex and one face a
/// line; the count of edges may be missing or wrong, as nobody fills it in.
///
/// Strict and ours: CGAL's reader stops at the first odd line and keeps what it has, OpenMesh's drops faces.
///
/// Throws Error(bad_input) with the line for what is no OFF, for its binary, 4-dimensional and n-dimensional
/// kinds, and as PolygonSoup::finish().
MeshFile parse_off(std::string_view text, std::string_view file_name);

/// Whether a first word is one of OFF.
bool is_off_keyword(std::string_view word);

}  // namespace offing::meshes
