#pragma once

#include <filesystem>
#include <string>

#include "host/io/file_trust.h"
#include "host/io/meshes/mesh_file.h"

namespace offing {

/// The mesh of a file: OBJ, PLY (text, binary), OFF, STL (text, binary), glTF (.gltf, .glb). The name says
/// which, the content where it does not. Vertices are those of the file in its order (of an STL, which has
/// none: corners at one place are one vertex, numbered as they come), faces in its order, polygons of more
/// than three corners cut into triangles (meshes::PolygonCutter). Degenerate and repeated faces are kept. See
/// the parse_...() functions of this folder for what each format holds. A glTF may deform; `animation` is the
/// name of one that it has, empty: all of them (meshes::GltfScene).
///
/// Throws Error(bad_input) if there is no such file, it cannot be read, is no regular file, has no faces, is
/// of no known format or damaged: what() names file and line. Buffers of an untrusted glTF lie in its folder
/// or below.
MeshFile read_mesh_file(const std::filesystem::path& path, Trust trust = Trust::trusted,
                        const std::string& animation = "");

/// Logs a warning for each kind of thing that a mesh cannot hold.
void warn_of_left_out(const std::filesystem::path& path, const MeshReport& report);

/// read_mesh_file() and warn_of_left_out(); one that deforms is at rest.
TriangleMesh read_mesh(const std::filesystem::path& path, Trust trust = Trust::trusted);

}  // namespace offing
