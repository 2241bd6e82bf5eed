#include "host/bodies/hull_lift.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/bodies/hull.h"
#include "host/bodies/hydrostatics.h"
#include "host/bodies/radiation.h"

namespace offing::bodies {
namespace {

using std::numbers::pi;

/// The corners of the part of a face below a level, in order.
std::vector<glm::dvec3> part_below(const TriangleMesh& mesh, const TriangleIndices& face, double level_m) {
  std::vector<glm::dvec3> part;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = mesh.positions_m[face[i]], &to = mesh.positions_m[face[(i + 1) % 3]];
    if (from.y <= level_m) part.push_back(from);
    if ((from.y <= level_m) != (to.y <= level_m))
      part.push_back(from + (level_m - from.y) / (to.y - from.y) * (to - from));
  }
  return part;
}

}  // namespace

HullLift lift_of_hull(const FloatingBody& body, double density_kgpm3, const HullMatrix& added_mass) {
  HullLift lift;
  const double volume_m3 = body.mass_kg / density_kgpm3;
  // What sinks does not run ahead.
  if (!(volume_m3 < enclosed_by(body.hull).volume_m3)) return lift;
  const double level_m = level_that_displaces(body.hull, volume_m3, body.name.c_str());
  glm::dvec3 low(1e300), high(-1e300);
  for (const TriangleIndices& face : body.hull.faces) {
    for (const glm::dvec3& place : part_below(body.hull, face, level_m)) {
      low = glm::min(low, place);
      high = glm::max(high, place);
    }
  }
  const glm::dvec3 sides_m = high - low;
  const double l = sides_m.x, b = sides_m.z, t = sides_m.y, block = volume_m3 / (l * b * t);
  const double share = std::clamp((l / b - 2.0) / 2.0, 0.0, 1.0);
  if (share == 0.0) return lift;
  lift.share = share;
  const glm::dvec3 point(0.5 * (low.x + high.x), level_m - 0.5 * t, 0.5 * (low.z + high.z));
  lift.arm_m = point - body.mass_centre_m;

  // Clarke's axes: y to starboard, yaw about the axis down; of density / 2 length^2 speed^2 and so on.
  const double base = pi * (t / l) * (t / l);
  const double sway = -base * (1.0 + 0.4 * block * b / t);
  const double sway_by_yaw = -base * (-0.5 + 2.2 * b / l - 0.08 * b / t);
  const double yaw_by_sway = -base * (0.5 + 2.4 * t / l);
  const double yaw = -base * (0.25 + 0.039 * b / t - 0.56 * b / l);
  // What added mass A gives (Kirchhoff; Munk's moment): u A_xx q along z, u ((A_zz - A_xx) w + A_zq q) about
  // y.
  const HullMatrix added = about_another_point(added_mass, lift.arm_m);
  const double a_x = added[0] / density_kgpm3, a_z = added[2 * 6 + 2] / density_kgpm3,
               a_zq = added[2 * 6 + 4] / density_kgpm3;
  lift.force_by_sway_m2 = share * (-0.5 * l * l * sway);
  lift.force_by_yaw_m3 = share * (0.5 * l * l * l * sway_by_yaw + a_x);
  lift.moment_by_sway_m3 = share * (0.5 * l * l * l * yaw_by_sway + a_z - a_x);
  lift.moment_by_yaw_m4 = share * (-0.5 * l * l * l * l * yaw + a_zq);

  // Never work on the hull: force w + moment q <= 0 for all w and q.
  lift.force_by_sway_m2 = std::max(0.0, lift.force_by_sway_m2);
  lift.moment_by_yaw_m4 = std::max(0.0, lift.moment_by_yaw_m4);
  const double sum = lift.force_by_yaw_m3 + lift.moment_by_sway_m3;
  const double most = 2.0 * std::sqrt(lift.force_by_sway_m2 * lift.moment_by_yaw_m4);
  const double excess = sum - std::clamp(sum, -most, most);
  lift.force_by_yaw_m3 -= 0.5 * excess;
  lift.moment_by_sway_m3 -= 0.5 * excess;
  return lift;
}

}  // namespace offing::bodies
