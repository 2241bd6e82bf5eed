#include "tests/bodies/reference_forces.h"

#include <glm/geometric.hpp>

namespace offing::test {
namespace {

struct Corner {
  glm::dvec3 arm_m;
  double depth_m;
};

std::vector<Corner> part_under_water(const std::vector<Corner>& face) {
  std::vector<Corner> part;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Corner &from = face[i], &to = face[(i + 1) % face.size()];
    if (from.depth_m > 0.0) part.push_back(from);
    if ((from.depth_m > 0.0) != (to.depth_m > 0.0)) {
      const double share = from.depth_m / (from.depth_m - to.depth_m);
      part.push_back({from.arm_m + share * (to.arm_m - from.arm_m), 0.0});
    }
  }
  return part;
}

}  // namespace

ReferenceForces reference_forces(const bodies::FloatingBody& body, const bodies::BodyPose& pose,
                                 const std::vector<double>& depths_m, double weight_npm3) {
  ReferenceForces forces;
  for (const TriangleIndices& face : body.hull.faces) {
    std::vector<Corner> corners;
    for (const std::uint32_t vertex : face) {
      corners.push_back({pose.turn * (body.hull.positions_m[vertex] - body.mass_centre_m), depths_m[vertex]});
    }
    const std::vector<Corner> part = part_under_water(corners);
    for (std::size_t i = 2; i < part.size(); ++i) {
      const std::array<Corner, 3> triangle{part[0], part[i - 1], part[i]};
      const glm::dvec3 area =
          0.5 * glm::cross(triangle[1].arm_m - triangle[0].arm_m, triangle[2].arm_m - triangle[0].arm_m);
      forces.wetted_m2 += glm::length(area);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Corner &a = triangle[corner], &b = triangle[(corner + 1) % 3];
        const glm::dvec3 force = -weight_npm3 * 0.5 * (a.depth_m + b.depth_m) / 3.0 * area;
        forces.pressure_n += force;
        forces.pressure_moment_nm += glm::cross(0.5 * (a.arm_m + b.arm_m), force);
      }
    }
  }
  return forces;
}

}  // namespace offing::test
