#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

/// The neighbours of vertices, edges and faces in a mesh.
namespace offing {

/// For each vertex the first one at exactly the same place: seams of textures, and the corners of formats
/// without indices, fall together. Positions are finite; fewer than 2^32.
std::vector<std::uint32_t> first_at_place(std::span<const glm::dvec3> positions_m);

/// Lists of indices, one a row, one behind the other.
struct IndexLists {
  std::vector<std::uint32_t> begin{0};  ///< [rows + 1]: where a row's entries begin
  std::vector<std::uint32_t> entries;

  std::size_t rows() const { return begin.size() - 1; }
  std::span<const std::uint32_t> row(std::size_t index) const {
    return std::span(entries).subspan(begin[index], begin[index + 1] - begin[index]);
  }
};

/// Two vertices, the lower index first.
using EdgeIndices = std::array<std::uint32_t, 2>;

/// Who touches whom in a mesh. Nothing is assumed of it: an edge has any number of faces, in any orientation;
/// a vertex any number of fans, or none. Faces that name a vertex twice have no edges and are in no list.
struct MeshNeighbours {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<TriangleIndices> faces;       ///< [faces]
  std::vector<EdgeIndices> edges;           ///< [edges], each once, sorted
  std::vector<TriangleIndices> face_edges;  ///< [faces]: the edges corner 0 - 1, 1 - 2, 2 - 0; or none
  IndexLists vertex_faces;                  ///< of each vertex its faces, ascending
  IndexLists vertex_edges;                  ///< of each vertex its edges, ascending
  std::vector<std::uint32_t> neighbours;    ///< beside each entry of vertex_edges the edge's other vertex
  IndexLists edge_faces;                    ///< of each edge its faces, ascending

  std::size_t vertex_count() const { return vertex_faces.rows(); }
  std::span<const std::uint32_t> neighbours_of(std::size_t vertex) const {
    const std::size_t begin = vertex_edges.begin[vertex];
    return std::span(neighbours).subspan(begin, vertex_edges.begin[vertex + 1] - begin);
  }
  /// Whether a face that has the edge passes it from its first vertex to its second.
  bool runs_along(std::uint32_t face, std::uint32_t edge) const {
    const TriangleIndices& corners = faces[face];
    const auto& [from, to] = edges[edge];
    return (corners[0] == from && corners[1] == to) || (corners[1] == from && corners[2] == to) ||
           (corners[2] == from && corners[0] == to);
  }
};

/// The neighbours of a mesh of so many vertices. Throws Error(bad_input) where a face names a vertex that is
/// not there, and Error(out_of_memory) beyond 2^30 faces.
MeshNeighbours mesh_neighbours(std::size_t vertex_count, std::vector<TriangleIndices> faces);

/// The faces of a mesh with each vertex replaced by the first one at its place (first_at_place()).
std::vector<TriangleIndices> welded_faces(std::span<const TriangleIndices> faces,
                                          std::span<const std::uint32_t> first);

}  // namespace offing
