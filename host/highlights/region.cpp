#include "host/highlights/region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace offing::highlights {
namespace {

/// Whether a triangle and the square -1 ... 1 have a point in common: no line along a side of either parts
/// them.
bool reaches_square(const std::array<glm::dvec2, 3>& q) {
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax({q[0][axis], q[1][axis], q[2][axis]});
    if (low > 1.0 || high < -1.0) return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 side = q[(i + 1) % 3] - q[i];
    const glm::dvec2 across{-side.y, side.x};
    const double square = std::abs(across.x) + std::abs(across.y);
    const double line = glm::dot(across, q[i]), tip = glm::dot(across, q[(i + 2) % 3]);
    if (std::min(line, tip) > square || std::max(line, tip) < -square) return false;
  }
  return true;
}

}  // namespace

RegionSearch::RegionSearch(const HighlightSurface& surface)
    : surface_(&surface),
      face_marks_(surface.mesh().faces.size(), 0),
      place_marks_(surface.links().place_count(), 0) {}

void RegionSearch::find(const Projector& projector, std::uint32_t seed, std::vector<std::uint32_t>& faces) {
  if (round_ == std::numeric_limits<std::uint32_t>::max()) {
    std::fill(face_marks_.begin(), face_marks_.end(), 0);
    std::fill(place_marks_.begin(), place_marks_.end(), 0);
    round_ = 0;
  }
  ++round_;
  const TriangleMesh& mesh = surface_->mesh();
  const VertexLinks& links = surface_->links();
  const glm::dvec3 right = projector.right * (2.0 / projector.width_m);
  const glm::dvec3 up = projector.up * (2.0 / projector.height_m);
  const auto is_drawn_on = [&](std::uint32_t face) {
    if (!(glm::dot(surface_->face_normals()[face], projector.normal) > 0.0)) return false;
    std::array<glm::dvec2, 3> q;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 way = mesh.positions_m[mesh.faces[face][i]] - projector.centre_m;
      q[i] = {glm::dot(right, way), glm::dot(up, way)};
    }
    return reaches_square(q);
  };
  std::size_t next = faces.size();
  faces.push_back(seed);
  face_marks_[seed] = round_;
  for (; next < faces.size(); ++next) {
    for (const std::uint32_t corner : mesh.faces[faces[next]]) {
      const std::uint32_t place = links.place_of(corner);
      if (place_marks_[place] == round_) continue;
      place_marks_[place] = round_;
      for (const std::uint32_t face : links.faces_at(place)) {
        if (face_marks_[face] == round_) continue;
        face_marks_[face] = round_;
        if (is_drawn_on(face)) faces.push_back(face);
      }
    }
  }
}

}  // namespace offing::highlights
