#include "host/highlights/search/face_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

constexpr std::size_t most_in_leaf = 4;
// Halves of halves: 64 levels hold more faces than a mesh has.
constexpr std::size_t most_levels = 64;

constexpr double missed = -1.0;

/// Where the ray enters a box, `missed` where it does not before `longest`.
double entry(const glm::dvec3& low_m, const glm::dvec3& high_m, const glm::dvec3& origin_m,
             const glm::dvec3& direction, double longest) {
  double near = 0.0, far = longest;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) {
      if (origin_m[axis] < low_m[axis] || origin_m[axis] > high_m[axis]) return missed;
      continue;
    }
    const double a = (low_m[axis] - origin_m[axis]) / direction[axis];
    const double b = (high_m[axis] - origin_m[axis]) / direction[axis];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near <= far ? near : missed;
}

}  // namespace

FaceTree::FaceTree(const TriangleMesh& mesh) {
  corners_.reserve(mesh.faces.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const auto corner = [&](std::size_t i) { return mesh.positions_m[mesh.faces[face][i]]; };
    corners_.push_back({.face = static_cast<std::uint32_t>(face),
                        .first_m = corner(0),
                        .side_1_m = corner(1) - corner(0),
                        .side_2_m = corner(2) - corner(0)});
  }
  if (corners_.empty()) return;
  nodes_.push_back({.begin = 0, .count = static_cast<std::uint32_t>(corners_.size())});
  for (std::size_t node = 0; node < nodes_.size(); ++node) split(node);
}

/// Measures a node of the tree and, where it has many faces, gives each half of them, by their middles along
/// the box's longest side, a node of its own.
void FaceTree::split(std::size_t node) {
  const std::uint32_t begin = nodes_[node].begin, count = nodes_[node].count;
  const auto first = corners_.begin() + begin, last = first + count;
  glm::dvec3 low_m(std::numeric_limits<double>::infinity()), high_m = -low_m;
  for (auto face = first; face != last; ++face) {
    for (const glm::dvec3& way : {glm::dvec3(0.0), face->side_1_m, face->side_2_m}) {
      low_m = glm::min(low_m, face->first_m + way);
      high_m = glm::max(high_m, face->first_m + way);
    }
  }
  nodes_[node].low_m = low_m;
  nodes_[node].high_m = high_m;
  if (count <= most_in_leaf) return;
  const glm::dvec3 size = high_m - low_m;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto place = [&](const Corners& face) {
    return 3.0 * face.first_m[axis] + face.side_1_m[axis] + face.side_2_m[axis];
  };
  const std::uint32_t half = count / 2;
  std::nth_element(first, first + half, last, [&](const Corners& a, const Corners& b) {
    return place(a) < place(b) || (place(a) == place(b) && a.face < b.face);
  });
  nodes_[node].begin = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].count = 0;
  nodes_.push_back({.begin = begin, .count = half});
  nodes_.push_back({.begin = begin + half, .count = count - half});
}

/// Every face that the ray meets before `longest`, nearer boxes first. (Moeller & Trumbore 1997.)
template <class Visit>
void FaceTree::visit(const glm::dvec3& origin_m, const glm::dvec3& direction, double& longest,
                     const Visit& is_done) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, 2 * most_levels> waiting{};
  std::size_t count = 1;
  const auto enters = [&](std::uint32_t node) {
    return entry(nodes_[node].low_m, nodes_[node].high_m, origin_m, direction, longest);
  };
  while (count > 0) {
    const std::uint32_t number = waiting[--count];
    if (enters(number) == missed) continue;
    const Node& node = nodes_[number];
    if (node.count == 0) {
      const bool is_first_nearer = enters(node.begin) <= enters(node.begin + 1);
      waiting[count++] = is_first_nearer ? node.begin + 1 : node.begin;
      waiting[count++] = is_first_nearer ? node.begin : node.begin + 1;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.begin + node.count; ++i) {
      const Corners& face = corners_[i];
      const glm::dvec3 across = glm::cross(direction, face.side_2_m);
      const double volume = glm::dot(face.side_1_m, across);
      if (volume == 0.0) continue;
      const glm::dvec3 way = origin_m - face.first_m, turned = glm::cross(way, face.side_1_m);
      const double u = glm::dot(way, across) / volume, v = glm::dot(direction, turned) / volume;
      const double distance = glm::dot(face.side_2_m, turned) / volume;
      if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 && distance < longest)) continue;
      if (is_done(FaceHit{.face = face.face, .distance = distance, .weights = {1.0 - u - v, u, v}})) return;
    }
  }
}

std::optional<FaceHit> FaceTree::first_hit(const glm::dvec3& origin_m, const glm::dvec3& direction,
                                           double longest) const {
  std::optional<FaceHit> first;
  visit(origin_m, direction, longest, [&](const FaceHit& hit) {
    first = hit;
    longest = hit.distance;
    return false;
  });
  return first;
}

bool FaceTree::is_blocked(const glm::dvec3& origin_m, const glm::dvec3& direction, double longest) const {
  bool is_met = false;
  visit(origin_m, direction, longest, [&](const FaceHit&) { return is_met = true; });
  return is_met;
}

}  // namespace offing::highlights
