#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"
#include "host/bodies/floating_bodies.h"

namespace offing::test {

inline constexpr double sea_density_kgpm3 = 1025.0;

/// A box of these sides around the origin, its faces turned outward.
TriangleMesh box(const glm::dvec3& sides_m);
/// An icosphere of this radius.
TriangleMesh ball(double radius_m, int level = 3);
/// The ship of offing-mesh: `cells` along it, two thirds as many around.
TriangleMesh ship(double length_m, int cells = 48);

/// An open boat of offing-mesh: `cells` along it, as many around, half of them outside.
TriangleMesh boat(double length_m, int cells = 64);

/// Still water at this level, on the host.
bodies::FloatingBodies::WaterSurface still_water(double level_m = 0.0);

/// A long wave of small steepness that runs along +x, of linear theory on deep water, on the host.
struct LongWave {
  double amplitude_m = 1.0, wavelength_m = 200.0;
};
bodies::FloatingBodies::WaterSurface wavy_water(const LongWave& wave);

}  // namespace offing::test
