#include "host/bodies/floating_body.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/bodies/hull.h"
#include "host/bodies/hydrostatics.h"

namespace offing::bodies {
namespace {

constexpr double smallest_propeller_m = 1e-3, largest_propeller_m = 100.0, largest_rudder_m2 = 1e4;

/// Below the stern, where a ship has them; of a raft or an island the nearest in size that is allowed.
HullDrive drive_below_stern(const Extent& extent, double level_m) {
  const double draught_m = level_m - extent.low_m.y, length_m = extent.high_m.x - extent.low_m.x;
  const double middle_z_m = 0.5 * (extent.low_m.z + extent.high_m.z);
  const double below_m = level_m - 0.6 * draught_m;
  return {.propeller_m = {extent.low_m.x + 0.04 * length_m, below_m, middle_z_m},
          .propeller_diameter_m = std::clamp(0.6 * draught_m, smallest_propeller_m, largest_propeller_m),
          .rudder_m = {extent.low_m.x + 0.01 * length_m, below_m, middle_z_m},
          // What classification societies ask of merchant ships: some 2 % of length times draught.
          .rudder_area_m2 = std::min(0.02 * length_m * draught_m, largest_rudder_m2)};
}

bool is_positive_definite(const glm::dmat3& matrix) {
  return matrix[0][0] > 0.0 && matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[0][1] > 0.0 &&
         glm::determinant(matrix) > 0.0;
}

}  // namespace

FloatingBody load_to_level(std::string name, TriangleMesh hull, double level_m, double density_kgpm3,
                           double lift) {
  require_hull(hull, name.c_str());
  const Extent extent = extent_of(hull);
  if (!(level_m > extent.low_m.y && level_m < extent.high_m.y)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a water level between {:.4g} and {:.4g} m of its mesh, found {:.4g} m",
                    name, extent.low_m.y, extent.high_m.y, level_m),
        "choose a level at which it floats");
  }
  const Submerged below = submerged_below(hull, level_m);
  const Enclosed whole = enclosed_by(hull);
  FloatingBody body{.name = std::move(name), .hull = std::move(hull)};
  body.mass_kg = density_kgpm3 * below.volume_m3;
  body.mass_centre_m = below.centre_m + glm::dvec3(0.0, lift * (level_m - extent.low_m.y), 0.0);
  body.inertia_kgm2 = body.mass_kg / whole.volume_m3 * whole.inertia_m5;
  body.drive = drive_below_stern(extent, level_m);
  return body;
}

FloatingBody load_to_mass(std::string name, TriangleMesh hull, double mass_kg, double density_kgpm3,
                          double lift) {
  require_hull(hull, name.c_str());
  const double level_m = level_that_displaces(hull, mass_kg / density_kgpm3, name.c_str());
  return load_to_level(std::move(name), std::move(hull), level_m, density_kgpm3, lift);
}

BodyPose at_rest(const FloatingBody& body, double density_kgpm3, double x_m, double z_m, double heading_rad) {
  const double level_m = level_that_displaces(body.hull, body.mass_kg / density_kgpm3, body.name.c_str());
  return {.mass_centre_m = {x_m, body.mass_centre_m.y - level_m, z_m}, .turn = turn_of_heading(heading_rad)};
}

void require_valid(const FloatingBody& body) {
  require_hull(body.hull, body.name.c_str());
  const auto check = [&](const char* what, double value, double low, double high) {
    require_within(fmt::format("{}: {}", body.name, what), value, low, high);
  };
  check("mass_kg", body.mass_kg, 1e-3, 1e12);
  for (const auto& [what, value] : {std::pair{"drag.face", body.drag.face},
                                    {"drag.wake", body.drag.wake},
                                    {"drag.waves", body.drag.waves},
                                    {"drag.added_along", body.drag.added_along},
                                    {"drag.added_up", body.drag.added_up},
                                    {"drag.added_inertia", body.drag.added_inertia},
                                    {"drag.windage", body.drag.windage}}) {
    check(what, value, 0.0, 100.0);
  }
  check("drive.propeller_diameter_m", body.drive.propeller_diameter_m, smallest_propeller_m,
        largest_propeller_m);
  check("drive.rudder_area_m2", body.drive.rudder_area_m2, 0.0, largest_rudder_m2);
  check("drive.rudder_lift", body.drive.rudder_lift, 0.0, 2.0 * 3.15);
  for (const MooringLine& line : body.moorings) {
    for (int axis = 0; axis < 3; ++axis) {
      check("mooring.hull_m", line.hull_m[axis], -1e6, 1e6);
      check("mooring.anchor_m", line.anchor_m[axis], -1e9, 1e9);
    }
    check("mooring.length_m", line.length_m, 0.0, 1e9);
    check("mooring.stiffness_npm", line.stiffness_npm, 0.0, 1e15);
  }
  if (!is_positive_definite(body.inertia_kgm2)) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected moments of inertia above 0", body.name),
                "give those of a body that has a volume");
  }
}

}  // namespace offing::bodies
