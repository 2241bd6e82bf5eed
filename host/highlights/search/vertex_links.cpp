#include "host/highlights/search/vertex_links.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "host/base/disjoint_sets.h"
#include "host/base/vertex_places.h"

namespace offing::highlights {
namespace {

/// For each vertex of a face the first one at its place: copies of one vertex, however many, are compared to
/// none of the others. Vertices of no face are left out.
std::vector<std::uint32_t> places_of_faces(const TriangleMesh& mesh, DisjointSets& sets) {
  const std::vector<std::uint32_t> first = first_at_place(mesh.positions_m);
  std::vector<std::uint32_t> places;
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t corner : face) {
      places.push_back(first[corner]);
      sets.join(first[corner], corner);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Joins vertices of faces within the distance. Sorted along a line that no surface is likely to be built
/// across, each is compared to those that are not farther along it.
DisjointSets joined(const TriangleMesh& mesh, double distance_m) {
  const std::vector<glm::dvec3>& positions_m = mesh.positions_m;
  const glm::dvec3 line = glm::normalize(glm::dvec3(0.5377, 0.7103, 0.4543));
  DisjointSets sets(positions_m.size());
  std::vector<std::pair<double, std::uint32_t>> order;  // m along the line
  for (const std::uint32_t vertex : places_of_faces(mesh, sets)) {
    order.emplace_back(glm::dot(line, positions_m[vertex]), vertex);
  }
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [along_m, vertex] = order[i];
    for (std::size_t j = i + 1; j < order.size() && order[j].first <= along_m + distance_m; ++j) {
      const std::uint32_t other = order[j].second;
      if (glm::distance(positions_m[vertex], positions_m[other]) <= distance_m) sets.join(vertex, other);
    }
  }
  return sets;
}

}  // namespace

VertexLinks::VertexLinks(const TriangleMesh& mesh, double distance_m) {
  DisjointSets sets = joined(mesh, distance_m);
  places_.resize(mesh.positions_m.size());
  std::uint32_t count = 0;
  for (std::uint32_t vertex = 0; vertex < places_.size(); ++vertex) {
    const std::uint32_t root = sets.root_of(vertex).index;
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
