#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/cloud_volume.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds::test {

/// Particles at random in an ellipsoid around the origin, without what is below base_m, radii between two
/// numbers.
struct Heap {
  std::uint64_t seed = 1;
  int count = 100;
  glm::dvec3 half_axes_m{500.0, 350.0, 500.0};
  double base_m = -100.0;
  double least_radius_m = 60.0, most_radius_m = 160.0;
  double extinction_per_m = 0.02;  ///< in the middle of a particle
  std::uint32_t cloud = 0;
};

std::vector<CloudParticle> heap(const Heap& heap);

/// A layer of particles side by side, of this optical depth in the mean, half_width_m to each side.
std::vector<CloudParticle> layer(double optical_depth, double half_width_m, double thickness_m,
                                 double spacing_m);

/// The extinction of particles on a grid, in double precision: the sum of h at the middle of each cell,
/// scaled so that each particle keeps its optical mass.
CloudVolume volume_of(std::span<const CloudParticle> particles, double cell_m);

/// Of each value of that volume: the mean of the particles' albedos, by the extinction that each has there.
std::vector<std::array<float, 3>> albedo_of(std::span<const CloudParticle> particles,
                                            const CloudVolume& volume);

/// Particles as billboards, as an eye in the direction `toward_eye` sees them from far away, blended in
/// double precision.
struct SpriteView {
  glm::dvec3 intensity_kcd{0.0};  ///< radiance times area
  double covered_m2 = 0.0;        ///< opacity times area
  int pixels = 0;                 ///< a side of `light`
  double pixel_m = 0.0;
  std::vector<glm::dvec3> light;  ///< [pixels][pixels] kcd/m^2, premultiplied, row 0 at the top
  std::vector<double> opacity;    ///< [pixels][pixels]
};

SpriteView view_of(std::span<const CloudParticle> particles, std::span<const CloudSprite> sprites,
                   const glm::dvec3& middle_m, double radius_m, const glm::dvec3& toward_eye, int pixels);

}  // namespace offing::clouds::test
