#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/cloud_volume.h"
#include "host/ocl/device.h"

namespace offing::clouds {

/// One a value of a field's density, in its order: the albedo that a shape has there, between the middles of
/// its cells, by the density that each has. Both volumes in the same axes; the shape tells albedos.
std::vector<std::array<float, 3>> field_albedo(const CloudVolume& shape, const CloudVolume& field);

/// That of a shape which tells albedos, at a place: between the middles of cells, by their densities; 1 where
/// it has none.
std::array<float, 3> albedo_at(const CloudVolume& shape, const glm::dvec3& place_m);

/// One a value of the density that rasterised() makes of the particles (host/clouds/shape/cloud_density.h):
/// the mean of theirs, by the extinction that each has there. Empty where all have one grey. Throws as
/// rasterised().
std::vector<std::array<float, 3>> rasterised_albedo(const ocl::Device& device,
                                                    std::span<const CloudParticle> particles,
                                                    const CloudVolume& volume);

}  // namespace offing::clouds
