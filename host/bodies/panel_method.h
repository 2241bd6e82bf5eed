// The linear forces on a hull at rest in deep water, by a panel method, and what follows from such data.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/sea/hydrodynamic_data.h"
#include "host/base/triangle_mesh.h"
#include "host/bodies/hydrostatics.h"

namespace offing::bodies {

/// How finely a hull is computed.
struct PanelOptions {
  std::size_t panels = 270;      ///< of the wetted hull, as panel_hull() has them
  std::size_t frequencies = 24;  ///< at least 2
  int threads = 0;               ///< 0: as many as there are processors
  /// Damping from pressures and excitation from the diffracted waves, rather than both by Haskind's relation,
  /// which keeps the damping from ever being negative. Only tests need it.
  bool is_direct = false;
};

/// Added mass, damping and excitation of a closed hull that floats with its water line at y = level_m of its
/// mesh, in waves from 60 down to 0.6 times the geometric mean of its length and breadth, every 15 degrees.
/// Three-dimensional linear potential flow on deep water without forward speed: constant sources on flat
/// panels (Hess & Smith 1964) with the Green function of waves (Newman 1985). 0.4 to 1 s on one core of a
/// busy machine. Throws Error(bad_input) if nothing of the hull is below the level.
HydrodynamicData panel_method(const TriangleMesh& hull, double level_m, const glm::dvec3& about_m,
                              double density_kgpm3, double gravity_mps2, const PanelOptions& options = {});

/// The data at any frequency and direction of travel: cubic between those that it has, the nearest beyond.
HullMatrix added_mass_at(const HydrodynamicData& data, double frequency_radps);
HullMatrix damping_at(const HydrodynamicData& data, double frequency_radps);
HullWrench excitation_at(const HydrodynamicData& data, double frequency_radps, double direction_rad);

/// K(t) = 2 / pi integral of B(omega) cos(omega t) d omega (Cummins 1962, Ogilvie 1964) at 0, step_s,
/// 2 step_s, ...: B rises from 0 as its first values do, and falls beyond the last as a power that fits the
/// last ones, led to 0 between 2 and 3 times the last frequency.
std::vector<HullMatrix> retardation(const HydrodynamicData& data, double step_s, std::size_t count);

/// Added mass at infinite frequency, of data that lack it (Ogilvie 1964): the mean over the upper half of the
/// frequencies of A(omega) + 1 / omega integral of K(t) sin(omega t) dt.
HullMatrix added_mass_by_damping(const HydrodynamicData& data);

/// The restoring forces on a body that floats upright at rest, about about_m, per motion (N/m, N, N m).
HullMatrix restoring_matrix(const Submerged& below, const glm::dvec3& mass_centre_m,
                            const glm::dvec3& about_m, double density_kgpm3, double gravity_mps2);

/// The mass matrix about about_m of a body with this inertia about its mass centre, in the hull's axes.
HullMatrix mass_matrix(double body_kg, const std::array<double, 9>& inertia_kgm2,
                       const glm::dvec3& mass_centre_m, const glm::dvec3& about_m);

/// Motions about about_m per metre of wave amplitude (m/m, rad/m), as amplitudes of e^(-i omega t).
HullWrench linear_response(const HydrodynamicData& data, const HullMatrix& mass, const HullMatrix& restoring,
                           double frequency_radps, double direction_rad);

/// Natural periods without damping of heave, roll (about x) and pitch (about z), s; 0 for a motion without a
/// restoring force.
struct NaturalPeriods {
  double heave_s = 0.0, roll_s = 0.0, pitch_s = 0.0;
};
NaturalPeriods natural_periods(const HydrodynamicData& data, const HullMatrix& mass,
                               const HullMatrix& restoring);

}  // namespace offing::bodies
