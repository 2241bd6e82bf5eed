#pragma once

#include <cstddef>
#include <string_view>

#include "host/base/log.h"
#include "host/base/triangle_mesh.h"
#include "host/base/work.h"

namespace offing::mesh_tools {

/// A mesh of at most so many faces, as far as the shape allows it: edges are collapsed where that changes the
/// surface least (quadrics of Garland and Heckbert 1997, in CGAL), never so that a face turns over. The mesh
/// must be a manifold, else Error(bad_input) names the file. Throws Error(cancelled) when asked to stop.
TriangleMesh simplify_to_faces(const TriangleMesh& mesh, std::string_view file_name, std::size_t faces,
                               const CancelToken& cancel, Verbosity verbosity);

/// The same by collapsing edges to their middles, the shortest first, until none is shorter than `edge_m`.
TriangleMesh simplify_to_edges(const TriangleMesh& mesh, std::string_view file_name, double edge_m,
                               const CancelToken& cancel, Verbosity verbosity);

}  // namespace offing::mesh_tools
