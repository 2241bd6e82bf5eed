#include "mesh_tools/curvature/curvature_colours.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::mesh_tools {
namespace {

using Colour = std::array<double, 3>;

// The ends of a map whose lightness falls alike to both sides; colour-blind eyes tell them apart. sRGB.
constexpr Colour negative{33.0, 102.0, 172.0}, zero{247.0, 247.0, 247.0}, positive{178.0, 24.0, 43.0};

double value_of(const VertexCurvatures& curvatures, std::size_t vertex, CurvatureColour by) {
  const double k_max = curvatures.k_max_per_m[vertex], k_min = curvatures.k_min_per_m[vertex];
  switch (by) {
    case CurvatureColour::mean:
      return 0.5 * (k_max + k_min);
    case CurvatureColour::gauss:
      return k_max * k_min;
    case CurvatureColour::k_max:
      return k_max;
    case CurvatureColour::k_min:
      return k_min;
    case CurvatureColour::shape_index:
      // A plane has none: 0.
      return 2.0 / std::numbers::pi * std::atan2(k_max + k_min, k_max - k_min);
  }
  return 0.0;
}

double high_percentile(const std::vector<double>& values) {
  std::vector<double> magnitudes(values.size());
  std::ranges::transform(values, magnitudes.begin(), [](double value) { return std::abs(value); });
  if (magnitudes.empty()) return 0.0;
  const auto place =
      magnitudes.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), place, magnitudes.end());
  return *place;
}

}  // namespace

ColouredVertices colour_vertices(const VertexCurvatures& curvatures, CurvatureColour by) {
  const std::size_t vertices = curvatures.k_max_per_m.size();
  std::vector<double> values(vertices);
  for (std::size_t i = 0; i < vertices; ++i) values[i] = value_of(curvatures, i, by);
  ColouredVertices coloured;
  coloured.limit = by == CurvatureColour::shape_index ? 1.0 : high_percentile(values);
  for (const double value : values) {
    const double share = coloured.limit > 0.0 ? std::clamp(value / coloured.limit, -1.0, 1.0) : 0.0;
    const Colour& end = share < 0.0 ? negative : positive;
    std::array<std::uint8_t, 3>& colour = coloured.colours.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      colour[i] = static_cast<std::uint8_t>(std::lround(zero[i] + std::abs(share) * (end[i] - zero[i])));
    }
  }
  return coloured;
}

}  // namespace offing::mesh_tools
