#pragma once

#include <cstddef>

#include "host/base/triangle_mesh.h"
#include "host/bodies/hull_map.h"

namespace offing::bodies {

/// The hull that water presses on: that of a mesh that is closed, of at most `most_faces` faces or as many as
/// a box has. What an open boat holds is covered at its rim, so that it floats as long as no water runs over
/// it. Vertices that share a square of a grid become one, and what volume that costs is made up for by
/// breadth and length.
TriangleMesh pressed_hull(const TriangleMesh& mesh, const HullMap& map, std::size_t most_faces);

}  // namespace offing::bodies
