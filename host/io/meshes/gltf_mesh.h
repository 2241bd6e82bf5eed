#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/io/file_trust.h"
#include "host/io/meshes/mesh_file.h"

namespace offing::meshes {

/// The triangles of a glTF 2.0 file (.gltf with buffers beside it or within, .glb) as its scene shows them:
/// of each node with a mesh, in the order of the tree, the vertices of its primitives, moved by the node, in
/// their order. Primitives of a mesh that share their vertices share them here. Strips and fans become
/// triangles; a node that mirrors turns its faces over. Normals are kept if all primitives and morphs have
/// them. Points, lines and meshes of other scenes are left out and counted. Compressed meshes are refused.
///
/// Where nodes, skins or weights of morphs are animated, the mesh deforms. `animation` is that of GltfScene.
///
/// Ours above nlohmann-json, because tinygltf 2.7 checks no accessor against its buffer, which is most of the
/// work, but decodes each picture and opens each file that a document names.
///
/// Throws Error(bad_input) for what is no glTF or refers to what is not there, and as PolygonSoup::finish().
MeshFile parse_gltf(std::string_view bytes, const std::filesystem::path& path, Trust trust = Trust::trusted,
                    const std::string& animation = "");

}  // namespace offing::meshes
