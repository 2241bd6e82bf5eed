#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// Gradient noise of four dimensions, at a place in wavelengths: of an octave, without its shift.
double reference_noise(std::uint64_t seed, int octave, const std::array<double, 4>& place);

/// The noise of a cloud (C2) in double precision, in (0, 1), all octaves whose wavelength is shortest_m at
/// least: written for one point at a time, all 16 corners summed, no fixed point.
double reference_turbulence(const Turbulence& turbulence, std::uint64_t seed, const glm::dvec3& place_m,
                            double time_s, double shortest_m);

/// The density of metaballs (C1 ... C3) at a place in the cloud's axes.
double reference_density(const CloudParameters& parameters, const glm::dvec3& place_m, double time_s,
                         double shortest_m);

}  // namespace offing::clouds
