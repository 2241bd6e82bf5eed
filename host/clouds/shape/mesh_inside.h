#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::clouds {

/// Which cells of a grid have their middles inside a mesh: [z][y][x], 1 inside and 0 outside. A place is
/// inside where the surface winds around it, by faces crossed along lines to it, their orientation counted,
/// so that parts may overlap; and it has to be inside along two of the three axes at least, so that a hole or
/// a face turned around leaves no hollow and no ray of cloud. Lines through edges and vertices cross one face
/// alone there. The mesh lies inside the grid; middles are at corner_m + (i + 1/2) cell_m.
std::vector<std::uint8_t> cells_inside(const TriangleMesh& mesh, const glm::dvec3& corner_m, double cell_m,
                                       const std::array<int, 3>& cells);

}  // namespace offing::clouds
