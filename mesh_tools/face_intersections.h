#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/base/triangle_mesh.h"
#include "host/base/work.h"

namespace offing::mesh_tools {

/// Faces whose corners lie at one place or on one line, decided exactly.
bool has_no_area(const TriangleMesh& mesh, const TriangleIndices& face);
std::size_t count_faces_without_area(const TriangleMesh& mesh);

/// Pairs of faces, the lower number first, in order, that meet elsewhere than in corners and edges which they
/// share; decided exactly, by CGAL's predicates. Vertices at one place are taken for one, so that seams are
/// no intersections. Faces without an area have no part in it, nor have pairs of the same three vertices.
/// Works on any faces, a half-edge structure is not needed. Throws Error(cancelled) when asked to stop.
std::vector<std::array<std::uint32_t, 2>> intersecting_faces(const TriangleMesh& mesh,
                                                             const CancelToken& cancel);

}  // namespace offing::mesh_tools
