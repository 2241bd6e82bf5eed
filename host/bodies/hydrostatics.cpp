#include "host/bodies/hydrostatics.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::bodies {
namespace {

/// The corners of what is left of a triangle below the level, in order: 0, 3 or 4 of them.
struct Polygon {
  std::array<glm::dvec3, 4> corners;
  int count = 0;
};

Polygon part_below(const std::array<glm::dvec3, 3>& triangle, double level_m) {
  Polygon part;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = triangle[i], &to = triangle[(i + 1) % 3];
    const bool is_below = from.y <= level_m;
    if (is_below) part.corners[static_cast<std::size_t>(part.count++)] = from;
    if (is_below != (to.y <= level_m)) {
      const double share = (level_m - from.y) / (to.y - from.y);
      glm::dvec3 crossing = from + share * (to - from);
      crossing.y = level_m;
      part.corners[static_cast<std::size_t>(part.count++)] = crossing;
    }
  }
  return part;
}

}  // namespace

Submerged submerged_below(const TriangleMesh& hull, double level_m) {
  // The part below with its maximum, as tetrahedra from a point of the maximum's plane: the maximum itself
  // adds nothing to the volume. The maximum is what the part's shadow on the plane leaves: its integrals are
  // the negative sum of those of the projected faces.
  glm::dvec3 origin(0.0);
  for (const glm::dvec3& place : hull.positions_m)
    origin += place / static_cast<double>(hull.positions_m.size());
  origin.y = level_m;
  Submerged result;
  glm::dvec3 first(0.0), plane_first(0.0);
  for (const TriangleIndices& face : hull.faces) {
    const Polygon part = part_below(
        {hull.positions_m[face[0]], hull.positions_m[face[1]], hull.positions_m[face[2]]}, level_m);
    for (int corner = 2; corner < part.count; ++corner) {
      const glm::dvec3 a = part.corners[0] - origin,
                       b = part.corners[static_cast<std::size_t>(corner) - 1] - origin,
                       c = part.corners[static_cast<std::size_t>(corner)] - origin;
      const double volume = glm::dot(a, glm::cross(b, c)) / 6.0;
      const double shadow = -0.5 * glm::cross(b - a, c - a).y;
      const glm::dvec3 sum = a + b + c;
      result.volume_m3 += volume;
      first += volume / 4.0 * sum;
      result.plane_m2 += shadow;
      plane_first += shadow / 3.0 * sum;
      result.plane_xx_m4 += shadow / 12.0 * (a.x * a.x + b.x * b.x + c.x * c.x + sum.x * sum.x);
      result.plane_zz_m4 += shadow / 12.0 * (a.z * a.z + b.z * b.z + c.z * c.z + sum.z * sum.z);
    }
  }
  if (result.volume_m3 > 0.0) result.centre_m = origin + first / result.volume_m3;
  if (result.plane_m2 > 0.0) {
    const glm::dvec3 centre = plane_first / result.plane_m2;
    result.plane_xx_m4 -= result.plane_m2 * centre.x * centre.x;
    result.plane_zz_m4 -= result.plane_m2 * centre.z * centre.z;
    result.plane_centre_m = {origin.x + centre.x, level_m, origin.z + centre.z};
  }
  return result;
}

double level_that_displaces(const TriangleMesh& hull, double volume_m3, const char* subject) {
  const Extent extent = extent_of(hull);
  double low_m = extent.low_m.y, high_m = extent.high_m.y;
  const double whole_m3 = submerged_below(hull, high_m).volume_m3;
  if (!(volume_m3 > 0.0 && volume_m3 < whole_m3)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a mass that displaces less than the hull's {:.4g} m3, found {:.4g} m3",
                    subject, whole_m3, volume_m3),
        "make it lighter, or its hull larger");
  }
  // The volume grows with the level: 60 halvings leave less than a double's last digit of the height.
  for (int i = 0; i < 60; ++i) {
    const double middle_m = 0.5 * (low_m + high_m);
    (submerged_below(hull, middle_m).volume_m3 < volume_m3 ? low_m : high_m) = middle_m;
  }
  return 0.5 * (low_m + high_m);
}

}  // namespace offing::bodies
