#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "kernels/shared/bodies.h"

namespace offing::bodies {

/// A kind of forces of BodyReport.
struct ForceKind {
  const char *name, *meaning;
};

/// In the order of BodyForce.
inline constexpr std::array<ForceKind, BODY_FORCE_KINDS> force_kinds{{
    {"pressure", "pressure of the water below its moving surface"},
    {"drag", "friction and drag of the water, and lift of a hull that runs ahead"},
    {"radiation", "waves that the hull has made"},
    {"excitation", "waves, besides the pressure below their surface"},
    {"propeller", "thrust"},
    {"rudder", "rudder"},
    {"gravity", "weight"},
    {"wind", "wind on the dry part of the hull"},
    {"mooring", "mooring lines"},
}};

/// Of a kind, N, in world axes.
inline glm::dvec3 force_of(const BodyReport& report, BodyForce kind) {
  const float* at = report.forces + BODY_MOTIONS * kind;
  return {at[0], at[1], at[2]};
}
/// Its moment about the mass centre, N m.
inline glm::dvec3 moment_of(const BodyReport& report, BodyForce kind) {
  const float* at = report.forces + BODY_MOTIONS * kind + 3;
  return {at[0], at[1], at[2]};
}

}  // namespace offing::bodies
