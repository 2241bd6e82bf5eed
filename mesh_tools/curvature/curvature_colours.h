#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/base/triangle_mesh.h"

namespace offing::mesh_tools {

/// What vertices are coloured by.
enum class CurvatureColour {
  mean,   ///< (k_max + k_min) / 2
  gauss,  ///< k_max k_min
  k_max,
  k_min,
  shape_index,  ///< 2 / pi atan((k_max + k_min) / (k_max - k_min)): -1 cup, 0 saddle, 1 cap (Koenderink 1992)
};

/// In the order of the enumeration.
inline constexpr std::array<std::string_view, 5> curvature_colour_names{"mean", "gauss", "kmax", "kmin",
                                                                        "shape-index"};

struct ColouredVertices {
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< [vertices], sRGB
  double limit = 0.0;  ///< the value of full colour, in 1/m, 1/m^2 for gauss, 1 for the shape index
};

/// Blue below 0, white at 0, red above, full at the 98th percentile of all magnitudes and beyond: a few sharp
/// edges must not leave all else white.
ColouredVertices colour_vertices(const VertexCurvatures& curvatures, CurvatureColour by);

}  // namespace offing::mesh_tools
