// A surface as triangles of about one size and shape, for panels of a hull.
#pragma once

#include <cstddef>

#include "host/base/triangle_mesh.h"

namespace offing::bodies {

/// About `count` nearly equilateral triangles on a surface whose faces share vertices: isotropic remeshing
/// (Botsch & Kobbelt 2004, A remeshing approach to multiresolution modeling) by splitting, collapsing and
/// flipping edges and moving vertices along the surface. Borders and creases of more than 40 degrees stay, as
/// do their corners; a coordinate that is 0 along a border stays 0. Where they leave no room for as few
/// triangles, creases go, then there are more. No faces: none.
TriangleMesh even_mesh(const TriangleMesh& surface, std::size_t count);

}  // namespace offing::bodies
