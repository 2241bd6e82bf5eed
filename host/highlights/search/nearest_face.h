#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "host/highlights/search/highlight_surface.h"

namespace offing::highlights {

/// A face from which none that it touches is nearer to a point, found by steps downhill from `face`.
std::uint32_t nearest_face(const HighlightSurface& surface, std::uint32_t face, const glm::dvec3& point_m);

}  // namespace offing::highlights
