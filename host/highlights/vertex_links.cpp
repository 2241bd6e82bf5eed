#include "host/highlights/vertex_links.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

/// The first member of a vertex' set; halves the way to it.
std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t vertex) {
  while (parents[vertex] != vertex) {
    parents[vertex] = parents[parents[vertex]];
    vertex = parents[vertex];
  }
  return vertex;
}

void join(std::vector<std::uint32_t>& parents, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t root_a = root_of(parents, a), root_b = root_of(parents, b);
  parents[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

/// Joins vertices within the distance. Sorted along a line that no surface is likely to be built across, each
/// is compared to those that are not farther along it.
std::vector<std::uint32_t> joined(const std::vector<glm::dvec3>& positions_m, double distance_m) {
  const glm::dvec3 line = glm::normalize(glm::dvec3(0.5377, 0.7103, 0.4543));
  std::vector<double> along_m(positions_m.size());
  std::vector<std::uint32_t> parents(positions_m.size()), order(positions_m.size());
  for (std::size_t i = 0; i < positions_m.size(); ++i) along_m[i] = glm::dot(line, positions_m[i]);
  std::iota(parents.begin(), parents.end(), 0u);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return along_m[a] != along_m[b] ? along_m[a] < along_m[b] : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double end_m = along_m[order[i]] + distance_m;
    for (std::size_t j = i + 1; j < order.size() && along_m[order[j]] <= end_m; ++j) {
      if (glm::distance(positions_m[order[i]], positions_m[order[j]]) <= distance_m) {
        join(parents, order[i], order[j]);
      }
    }
  }
  return parents;
}

}  // namespace

VertexLinks::VertexLinks(const TriangleMesh& mesh, double distance_m) {
  std::vector<std::uint32_t> parents = joined(mesh.positions_m, distance_m);
  places_.resize(parents.size());
  std::uint32_t count = 0;
  for (std::uint32_t vertex = 0; vertex < places_.size(); ++vertex) {
    const std::uint32_t root = root_of(parents, vertex);
    places_[vertex] = root == vertex ? count++ : places_[root];
  }
  first_face_.assign(count + 1, 0);
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t corner : face) ++first_face_[places_[corner] + 1];
  }
  std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
  faces_.resize(3 * mesh.faces.size());
  std::vector<std::uint32_t> next(first_face_.begin(), first_face_.end() - 1);
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    for (const std::uint32_t corner : mesh.faces[face]) faces_[next[places_[corner]]++] = face;
  }
}

}  // namespace offing::highlights
