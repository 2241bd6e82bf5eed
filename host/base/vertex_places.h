#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace offing {

/// For each vertex the first one at exactly the same place: seams of textures, and the corners of formats
/// without indices, fall together. Positions are finite; fewer than 2^32.
std::vector<std::uint32_t> first_at_place(std::span<const glm::dvec3> positions_m);

}  // namespace offing
