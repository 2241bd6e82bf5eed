#include "host/highlights/search/merged_points.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

bool are_neighbours(const HighlightSurface& surface, std::uint32_t a, std::uint32_t b) {
  const auto place = [&](std::uint32_t face, std::size_t corner) {
    return surface.links().place_of(surface.mesh().faces[face][corner]);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (place(a, i) == place(b, j)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<HighlightPoint> merged_points(const HighlightSurface& surface,
                                          const std::vector<HighlightPoint>& points) {
  const double reach_m = 0.1 * surface.mean_edge_m();
  std::vector<HighlightPoint> kept;
  for (const HighlightPoint& point : points) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const HighlightPoint& other) {
      return other.light == point.light && glm::distance(other.position_m, point.position_m) <= reach_m &&
             are_neighbours(surface, other.face, point.face);
    });
    if (same == kept.end()) {
      kept.push_back(point);
    } else if (point.n_dot_h > same->n_dot_h) {
      *same = point;
    }
  }
  return kept;
}

}  // namespace offing::highlights
