// The linear forces of waves and of the water around a moving hull, by frequency: what panel methods compute.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace offing {

/// Motions of a hull, in its own axes (x forward, y up, z to starboard): along x, y, z, then about x, y, z.
inline constexpr std::size_t hull_motions = 6;

/// [force][motion], row-major.
using HullMatrix = std::array<double, hull_motions * hull_motions>;
/// A force along each axis, then a moment about each, as amplitudes of e^(-i omega t).
using HullWrench = std::array<std::complex<double>, hull_motions>;

/// Added mass, radiation damping and wave excitation of a hull at rest in still water, in SI units, for one
/// density, gravity and depth of water.
///
/// A wave of amplitude 1 m that travels toward direction b has the elevation Re e^(i k (x cos b + z sin b) -
/// i omega t), in the hull's axes from about_m: its excitation is Re X e^(-i omega t). A motion with the
/// velocity Re V e^(-i omega t) gets the force Re (i omega A - B) V e^(-i omega t).
struct HydrodynamicData {
  std::string source;          ///< a file, or the method, for messages
  glm::dvec3 about_m{0.0};     ///< the point of moments and rotations, in the axes of the hull's mesh
  double water_level_m = 0.0;  ///< of the hull at rest, in the axes of its mesh
  double density_kgpm3 = 1025.0;
  double gravity_mps2 = 9.81;
  double depth_m = std::numeric_limits<double>::infinity();

  std::vector<double> frequencies_radps;  ///< above 0, rising
  std::vector<double> directions_rad;     ///< of travel, from +x toward +z, rising, within one turn
  std::vector<HullMatrix> added_mass;     ///< [frequency], kg, kg m, kg m^2
  std::vector<HullMatrix> damping;        ///< [frequency], kg/s, kg m/s, kg m^2/s
  std::vector<HullWrench> excitation;     ///< [frequency][direction], N/m, N
  HullMatrix added_mass_at_infinity{};    ///< of the highest frequencies
};

}  // namespace offing
