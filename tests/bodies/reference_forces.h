#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "host/bodies/floating_body.h"
#include "kernels/shared/query_params.h"

namespace offing::test {

struct ReferenceForces {
  glm::dvec3 pressure_n{0.0}, pressure_moment_nm{0.0};
  double wetted_m2 = 0.0;
};

/// The pressure on a body's submerged faces, in double precision: each face is cut at the waterline into
/// triangles, and integrated over each by the rule of its edges' middles, which is exact for second powers.
/// depths_m [vertices of the hull].
ReferenceForces reference_forces(const bodies::FloatingBody& body, const bodies::BodyPose& pose,
                                 const std::vector<double>& depths_m, double weight_npm3);

}  // namespace offing::test
