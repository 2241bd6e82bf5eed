// What a file of hydrodynamic data holds, before it has our axes.
#pragma once

#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/sea/hydrodynamic_data.h"

namespace offing::hydrodynamics {

/// What a file says of a hull.
struct HydrodynamicFile {
  /// Its water level is 0: the file's plane z = 0 is the still water.
  HydrodynamicData data;
  bool has_infinite_frequency = false;    ///< else data.added_mass_at_infinity is that of the highest one
  std::optional<HullMatrix> restoring{};  ///< N/m, N, N m, of the hull at rest
};

/// The same in the axes of panel methods: x forward, y to port, z up from the still water; motions along x,
/// y, z, then about x, y, z. A wave that travels toward b has the elevation Re e^(i k (x cos b + y sin b) - i
/// omega t).
struct HydrodynamicTable {
  std::string name;  ///< of the file, for messages
  double density_kgpm3 = 1025.0, gravity_mps2 = 9.81;
  double depth_m = std::numeric_limits<double>::infinity();
  glm::dvec3 about_m{0.0};
  std::vector<double> frequencies_radps;  ///< in any order; 0 and infinity may be there, without excitation
  std::vector<double> directions_rad;     ///< in any order
  std::vector<HullMatrix> added_mass, damping;  ///< [frequency], SI units
  std::vector<HullWrench> excitation;           ///< [frequency][direction]
  std::optional<HullMatrix> restoring{};
};

/// In rising order and in the axes of hulls. If the directions span at most half a turn and the matrices are
/// those of a hull with a plane of symmetry along x, the other half are their images. Throws Error(bad_input)
/// that names the file for values that are not finite or out of range, frequencies or directions that come
/// twice, and negative damping of a motion.
HydrodynamicFile in_hull_axes(const HydrodynamicTable& table);

}  // namespace offing::hydrodynamics
