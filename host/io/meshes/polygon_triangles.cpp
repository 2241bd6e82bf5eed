#include "host/io/meshes/polygon_triangles.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace offing::meshes {
namespace {

/// Twice the area of the triangle, positive if it is anticlockwise.
double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Which way an edge points along x, or along y where it is upright.
bool points_forward(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace

bool PolygonCutter::cut(std::span<const std::uint32_t> corners, std::vector<TriangleIndices>& faces) {
  if (project(corners) && !is_convex()) return cut_ears(corners, faces);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    faces.push_back({corners[0], corners[i], corners[i + 1]});
  }
  return true;
}

/// Fills points_; false if the polygon has no normal.
bool PolygonCutter::project(std::span<const std::uint32_t> corners) {
  const glm::dvec3 origin = positions_m_[corners[0]];
  glm::dvec3 normal(0.0), last = positions_m_[corners.back()] - origin;
  for (const std::uint32_t corner : corners) {
    const glm::dvec3 next = positions_m_[corner] - origin;
    normal += glm::cross(last, next);
    last = next;
  }
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (!(size[axis] > 0.0)) return false;
  // Of the two other axes the one that makes the polygon anticlockwise comes first.
  int along_u = (axis + 1) % 3, along_v = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(along_u, along_v);
  points_.clear();
  for (const std::uint32_t corner : corners) {
    const glm::dvec3 point = positions_m_[corner] - origin;
    points_.emplace_back(point[along_u], point[along_v]);
  }
  return true;
}

/// Turns left at each corner, and once around in all: it changes from going forward to going back just once.
bool PolygonCutter::is_convex() const {
  const std::size_t count = points_.size();
  int changes = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 &a = points_[i], &b = points_[(i + 1) % count], &c = points_[(i + 2) % count];
    if (!(doubled_area(a, b, c) > 0.0)) return false;
    changes += points_forward(a, b) != points_forward(b, c);
  }
  return changes == 2;
}

double PolygonCutter::turn_at(std::uint32_t corner) const {
  return doubled_area(points_[before_[corner]], points_[corner], points_[after_[corner]]);
}

void PolygonCutter::find_reflex() {
  reflex_.clear();
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    if (!(turn_at(i) > 0.0)) reflex_.push_back(i);
  }
}

/// Whether the corner turns left and its triangle holds no other. Corners in the place of one of the
/// triangle's own do not count: polygons with holes run along a cut twice.
bool PolygonCutter::is_ear(std::uint32_t corner) {
  if (!(turn_at(corner) > 0.0)) return false;
  const glm::dvec2 &a = points_[before_[corner]], &b = points_[corner], &c = points_[after_[corner]];
  const auto is_within = [&](std::uint32_t other) {
    const glm::dvec2& p = points_[other];
    if (p == a || p == b || p == c) return false;
    return doubled_area(a, b, p) >= 0.0 && doubled_area(b, c, p) >= 0.0 && doubled_area(c, a, p) >= 0.0;
  };
  const auto found = std::find_if(reflex_.begin(), reflex_.end(), is_within);
  steps_ += static_cast<std::size_t>(found - reflex_.begin());
  return found == reflex_.end();
}

bool PolygonCutter::cut_ears(std::span<const std::uint32_t> corners, std::vector<TriangleIndices>& faces) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  before_.resize(count);
  after_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    before_[i] = (i + count - 1) % count;
    after_[i] = (i + 1) % count;
  }
  find_reflex();
  const std::size_t first_face = faces.size();
  std::uint32_t corner = 0, misses = 0;
  for (std::uint32_t left = count; left > 2;) {
    if (++steps_ > most_steps_) {
      faces.resize(first_face);
      return false;
    }
    const bool is_last_resort = left == 3 || misses >= left;
    if (!is_last_resort && !is_ear(corner)) {
      ++misses;
      corner = after_[corner];
      continue;
    }
    const std::uint32_t last = before_[corner], next = after_[corner];
    faces.push_back({corners[last], corners[corner], corners[next]});
    after_[last] = next;
    before_[next] = last;
    --left;
    misses = 0;
    // Corners turn no more to the right than before: the neighbours may leave the list, none enters it.
    std::erase_if(reflex_, [&](std::uint32_t i) {
      return i == corner || ((i == last || i == next) && turn_at(i) > 0.0);
    });
    steps_ += reflex_.size();
    corner = after_[next];  // not beside the last cut: better triangles than a fan
  }
  return true;
}

}  // namespace offing::meshes
