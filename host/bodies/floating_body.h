#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/sea/hydrodynamic_data.h"
#include "host/base/triangle_mesh.h"
#include "host/bodies/body_pose.h"

namespace offing::bodies {

/// Forces of the water on a moving hull besides its pressure. Coefficients are dimensionless and of usual
/// size for bluff hulls; friction needs none (ITTC 1957).
struct HullDrag {
  double face = 1.0;    ///< drag of faces that move against the water: half density * speed^2 * area
  double wake = 0.4;    ///< of those that move away from it
  double waves = 0.15;  ///< damping by the waves made, of density * area * sqrt(gravity * length) * speed
  /// Water that is accelerated with the body, in shares of the water that it displaces: along and upward.
  double added_along = 0.1, added_up = 0.8;
  /// And of its moments of inertia.
  double added_inertia = 0.5;
  /// Share of the force of wind on dry faces: above 1 for what stands on the hull and is not in its mesh.
  double windage = 1.0;
};

/// A line from a place on the hull to an anchor. It pulls by stiffness * (distance - length) where it is
/// longer than at rest, else it is slack. It weighs nothing.
struct MooringLine {
  glm::dvec3 hull_m{0.0};    ///< in the mesh's own axes
  glm::dvec3 anchor_m{0.0};  ///< in the world
  double length_m = 0.0;     ///< at rest
  double stiffness_npm = 0.0;
};

/// A propeller and the rudder behind it, in the mesh's own axes.
struct HullDrive {
  glm::dvec3 propeller_m{0.0};
  double propeller_diameter_m = 1.0;
  glm::dvec3 rudder_m{0.0};
  double rudder_area_m2 = 0.0;
  double rudder_lift =
      2.5;  ///< rise of the lift coefficient with the angle, 1/rad: an aspect ratio of about 1.5
};

/// A rigid body that water carries. The mesh's x is forward, y up, z to starboard; it is closed and its faces
/// turn outward (require_hull()).
struct FloatingBody {
  std::string name;   ///< for messages
  TriangleMesh hull;  ///< m
  double mass_kg = 0.0;
  glm::dvec3 mass_centre_m{0.0};  ///< in the mesh's own axes
  glm::dmat3 inertia_kgm2{0.0};   ///< about the mass centre, in the mesh's own axes, positive definite
  HullDrag drag = {};
  HullDrive drive = {};
  /// Added mass and the damping by the waves made. With them, the estimates of `drag` for both (waves,
  /// added_*) do not count; without, those do. built_in_data() makes them.
  std::shared_ptr<const HydrodynamicData> hydrodynamics = {};
  std::vector<MooringLine> moorings = {};
  BodyPose start = {};
};

/// How a body that floats upright and level is loaded: what it displaces up to this level of its mesh is its
/// mass; its mass centre stands above its centre of buoyancy by `lift` of the draught, and its inertia is
/// that of a body of even density. Propeller and rudder stand at the end at low x. Throws Error(bad_input)
/// that names the body for meshes that are no hulls, and levels that are not between the lowest and the
/// highest vertex.
FloatingBody load_to_level(std::string name, TriangleMesh hull, double level_m, double density_kgpm3,
                           double lift = 0.25);
/// The same for a mass: where it floats follows.
FloatingBody load_to_mass(std::string name, TriangleMesh hull, double mass_kg, double density_kgpm3,
                          double lift = 0.25);

/// Where it floats in still water at this place and heading: upright at its Archimedes draught.
BodyPose at_rest(const FloatingBody& body, double density_kgpm3, double x_m, double z_m, double heading_rad);

/// Throws Error(bad_input) that names the body and what is wrong with it.
void require_valid(const FloatingBody& body);

}  // namespace offing::bodies
