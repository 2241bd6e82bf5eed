#include "host/highlights/projectors/region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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

std::vector<std::uint32_t> first_copies(const HighlightSurface& surface) {
  const std::vector<TriangleIndices>& faces = surface.mesh().faces;
  std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> by_places;
  by_places.reserve(faces.size());
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    std::array<std::uint32_t, 3> places{};
    for (std::size_t i = 0; i < 3; ++i) places[i] = surface.links().place_of(faces[face][i]);
    std::sort(places.begin(), places.end());
    by_places.emplace_back(places, face);
  }
  std::sort(by_places.begin(), by_places.end());
  std::vector<std::uint32_t> first(faces.size());
  for (std::size_t i = 0; i < by_places.size(); ++i) {
    const auto& [places, face] = by_places[i];
    first[face] = i > 0 && by_places[i - 1].first == places ? first[by_places[i - 1].second] : face;
  }
  return first;
}

}  // namespace

RegionSearch::RegionSearch(const HighlightSurface& surface)
    : surface_(&surface),
      face_marks_(surface.mesh().faces.size(), 0),
      place_marks_(surface.links().place_count(), 0),
      first_copies_(first_copies(surface)),
      copy_marks_(surface.mesh().faces.size(), 0) {}

void RegionSearch::find(const Projector& projector, std::uint32_t seed, std::vector<std::uint32_t>& faces) {
  if (round_ == std::numeric_limits<std::uint32_t>::max()) {
    std::fill(face_marks_.begin(), face_marks_.end(), 0);
    std::fill(place_marks_.begin(), place_marks_.end(), 0);
    std::fill(copy_marks_.begin(), copy_marks_.end(), 0);
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
  face_marks_[seed] = copy_marks_[first_copies_[seed]] = round_;
  for (; next < faces.size(); ++next) {
    for (const std::uint32_t corner : mesh.faces[faces[next]]) {
      const std::uint32_t place = links.place_of(corner);
      if (place_marks_[place] == round_) continue;
      place_marks_[place] = round_;
      for (const std::uint32_t face : links.faces_at(place)) {
        if (face_marks_[face] == round_) continue;
        face_marks_[face] = round_;
        // What lies on another face would be drawn twice there.
        std::uint32_t& copy_mark = copy_marks_[first_copies_[face]];
        if (copy_mark == round_ || !is_drawn_on(face)) continue;
        copy_mark = round_;
        faces.push_back(face);
      }
    }
  }
}

}  // namespace offing::highlights
