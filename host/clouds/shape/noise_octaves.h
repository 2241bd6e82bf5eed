#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "host/clouds/shape/cloud_parameters.h"
#include "kernels/shared/cloud_field.h"

namespace offing::clouds {

/// Variance of gradient noise in four dimensions whose gradients have a length of 1, over all places:
/// 16 Q P^3, P and Q the integrals over 0 ... 1 of w^2 and w^2 t^2, w = 1 - 6 t^5 + 15 t^4 - 10 t^3. P is
/// 181 / 462, Q 535 / 18018.
inline constexpr double noise_variance =
    16.0 * (535.0 / 18018.0) * (181.0 / 462.0) * (181.0 / 462.0) * (181.0 / 462.0);

/// The octaves of a cloud's noise (C2) on a grid whose cells have middles origin_m + i cell_m in the cloud's
/// axes. Octave j is shorter than the first by lacunarity^j, weaker by gain^j, and changes faster by
/// lacunarity^(2j/3), as eddies of that size do (Kolmogorov 1941); each is shifted by its own random amount.
/// Those shorter than two cells are left out, which the sum's scale does not see: a finer grid adds detail
/// and changes nothing else.
std::vector<CloudOctave> noise_octaves(const Turbulence& turbulence, std::uint64_t seed,
                                       const glm::dvec3& origin_m, double cell_m, double time_s);

}  // namespace offing::clouds
