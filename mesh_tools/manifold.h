#pragma once

#include <string_view>

#include "host/base/triangle_mesh.h"

namespace offing::mesh_tools {

/// What half-edges can hold. Throws Error(bad_input) that names the file, and `offing-mesh repair` as the
/// fix, for an edge of three faces, a vertex of two fans, neighbours that disagree, a face that names a
/// vertex twice.
void require_manifold(const TriangleMesh& mesh, std::string_view file_name);

}  // namespace offing::mesh_tools
