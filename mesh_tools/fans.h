#pragma once

#include <cstdint>
#include <vector>

#include "host/base/triangle_mesh.h"

namespace offing::mesh_tools {

/// Turns faces so that neighbours at edges of two agree, in breadth from the first face of each part: where a
/// one-sided surface forbids it, the seam is short. is_turned [faces] is 1 for those that were turned.
void turn_in_breadth(TriangleMesh& mesh, std::vector<std::uint8_t>& is_turned);

/// Takes vertices apart so that only corners stay together whose faces are neighbours: two at an edge that
/// agree, or, of more at an edge, those that have the inside of one solid between them. The first fan of a
/// vertex keeps it, others get copies behind the last vertex.
void take_fans_apart(TriangleMesh& mesh);

}  // namespace offing::mesh_tools
