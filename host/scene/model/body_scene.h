#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace offing::scene {

/// What moves a body over the water: thrust, rudder and the water itself, or its path.
enum class BodyMotion { forces, path };

/// A mooring line of a body.
struct MooringScene {
  glm::dvec3 hull_m{0.0};                ///< in the axes of the hull
  glm::dvec3 anchor_m{0.0, -10.0, 0.0};  ///< in the world
  std::optional<double> length_m;        ///< where it is not given, the line is just taut at time 0
  double stiffness_npm = 1e4;
};

/// A body that floats, and moves a [[mesh]].
struct BodyScene {
  std::string name;
  std::string mesh;  ///< name of the [[mesh]]
  BodyMotion motion = BodyMotion::forces;
  std::optional<double> mass_kg;
  std::optional<double> draught_m;  ///< where neither is given, the density counts
  double density_kgpm3 = 400.0;
  std::optional<glm::dvec3> mass_centre_m;  ///< in the axes of the hull
  double x_m = 0.0, z_m = 0.0;
  double heading_rad = 0.0;
  double speed_mps = 0.0;
  double thrust_n = 0.0;
  double rudder_rad = 0.0;
  std::optional<double> propeller_m;  ///< diameter
  std::optional<double> rudder_m2;
  int hull_faces = 1000;
  std::string hydrodynamics;            ///< file of added mass, damping and excitation
  double hydrodynamics_length_m = 1.0;  ///< that WAMIT's numbers are divided by
  double windage = 1.0;                 ///< share of the force of wind on the hull
  std::vector<MooringScene> moorings;
};

}  // namespace offing::scene
