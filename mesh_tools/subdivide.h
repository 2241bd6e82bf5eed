#pragma once

#include <string_view>

#include "host/base/triangle_mesh.h"
#include "host/base/work.h"

namespace offing::mesh_tools {

enum class SubdivisionMethod { loop, sqrt3, butterfly, catmull_clark };

/// A finer mesh by OpenMesh: Loop 1987 and the modified butterfly of Zorin, Schroeder and Sweldens 1996
/// (which keeps the vertices where they are) make four faces of one, sqrt(3) of Kobbelt 2000 three, Catmull
/// and Clark 1978 three quadrilaterals of a triangle and then four of one, each cut into two triangles in the
/// end. Vertices of the mesh keep their numbers. The mesh must be a manifold: Error(bad_input) names the file
/// if it is none, or if the result would have more than 2^31 faces. Throws Error(cancelled) between levels.
TriangleMesh subdivide(const TriangleMesh& mesh, std::string_view file_name, SubdivisionMethod method,
                       int levels, const CancelToken& cancel);

}  // namespace offing::mesh_tools
