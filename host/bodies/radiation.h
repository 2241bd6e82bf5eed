#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "host/base/sea/hydrodynamic_data.h"

namespace offing::bodies {

/// What the waves that a hull makes do to it later, for steps in time (Cummins 1962): a force -A a - sum over
/// n of memory[n] v(now - n steps_a_sample steps), about the mass centre in the hull's axes.
struct HullMemory {
  HullMatrix added_mass{};  ///< A, at infinite frequency
  int steps_a_sample = 1;   ///< sub-steps from one sample of the velocity to the next
  /// Retardation function, times the time between samples; the first one is halved (trapezoidal rule).
  std::vector<HullMatrix> memory;
};

/// Of the hull's data. Its length sets how long it remembers, 30 sqrt(length / gravity), and how finely.
/// The function itself is that of retardation(). Throws Error(bad_input) that names the data for tables that
/// do not fit each other, or values that are no numbers.
HullMemory memory_of_hull(const HydrodynamicData& data, const glm::dvec3& mass_centre_m, double length_m,
                          double steps_per_s);

/// A matrix about another point, which is `arm_m` from the old one: rigid bodies' velocities there.
HullMatrix about_another_point(const HullMatrix& matrix, const glm::dvec3& arm_m);

}  // namespace offing::bodies
