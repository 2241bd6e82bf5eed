#pragma once

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"
#include "host/bodies/hull.h"

namespace offing::bodies {

/// The part of a hull below the plane y = level_m, and the water plane that it cuts out.
struct Submerged {
  double volume_m3 = 0.0;
  glm::dvec3 centre_m{0.0};  ///< of buoyancy
  double plane_m2 = 0.0;
  /// Second moments of the water plane about its own centre, m^4: of x^2 and z^2.
  double plane_xx_m4 = 0.0, plane_zz_m4 = 0.0;
  glm::dvec3 plane_centre_m{0.0};
};

/// In double precision and without a device; the hull as require_hull() asks.
Submerged submerged_below(const TriangleMesh& hull, double level_m);

/// The level in the hull's own axes at which it displaces this volume while it stands upright. Throws
/// Error(bad_input) that names `subject` where the volume is not within what the hull encloses: it sinks.
double level_that_displaces(const TriangleMesh& hull, double volume_m3, const char* subject);

}  // namespace offing::bodies
