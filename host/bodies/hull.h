#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::bodies {

/// What a closed surface encloses, in closed form (Eberly 2002: integrals over its faces).
struct Enclosed {
  double volume_m3 = 0.0;
  glm::dvec3 centre_m{0.0};
  /// Second moments about the centre at density 1, m^5: [i][j] = integral of (|r|^2 delta_ij - r_i r_j).
  glm::dmat3 inertia_m5{0.0};
};

/// Of a mesh whose faces turn outward.
Enclosed enclosed_by(const TriangleMesh& mesh);

/// Throws Error(bad_input) that names `subject` unless the mesh is closed, turned outward and encloses a
/// volume: water presses on a hull from outside only.
void require_hull(const TriangleMesh& mesh, const char* subject);

}  // namespace offing::bodies
