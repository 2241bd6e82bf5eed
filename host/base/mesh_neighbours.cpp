#include "host/base/mesh_neighbours.h"

#include <algorithm>
#include <compare>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {
namespace {

// So that three corners a face are still counted in 32 bits.
constexpr std::size_t most_faces = std::size_t{1} << 30;

bool has_three_corners(const TriangleIndices& face) {
  return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

void require_valid(std::size_t vertex_count, const std::vector<TriangleIndices>& faces) {
  if (faces.size() > most_faces || vertex_count >= MeshNeighbours::none) {
    throw Error(ErrorKind::out_of_memory,
                fmt::format("mesh: expected at most 2^30 faces, found {}", faces.size()),
                "simplify the mesh or split it into parts");
  }
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (const std::uint32_t vertex : faces[face]) {
      if (vertex < vertex_count) continue;
      throw Error(
          ErrorKind::bad_input,
          fmt::format("mesh: face {}: expected vertices below {}, found {}", face, vertex_count, vertex),
          "export the mesh again from the program that made it");
    }
  }
}

/// Turns counts, which stand one row too late, into where rows begin.
void sum_up(std::vector<std::uint32_t>& begin) {
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
}

/// Lists of those owners that name a row; owners are asked for their rows in order, so that lists ascend.
template <typename Visit>
IndexLists lists_of(std::size_t rows, std::size_t owners, const Visit& visit_rows) {
  IndexLists lists;
  lists.begin.assign(rows + 1, 0);
  for (std::size_t owner = 0; owner < owners; ++owner) {
    visit_rows(owner, [&](std::uint32_t row) { ++lists.begin[row + 1]; });
  }
  sum_up(lists.begin);
  lists.entries.resize(lists.begin.back());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  for (std::size_t owner = 0; owner < owners; ++owner) {
    visit_rows(owner,
               [&](std::uint32_t row) { lists.entries[next[row]++] = static_cast<std::uint32_t>(owner); });
  }
  return lists;
}

/// A side of a face, kept with the lower of its two vertices.
struct Side {
  std::uint32_t higher_vertex, face, corner;

  auto operator<=>(const Side&) const = default;
};

void find_edges(MeshNeighbours& mesh) {
  mesh.face_edges.assign(mesh.faces.size(),
                         {MeshNeighbours::none, MeshNeighbours::none, MeshNeighbours::none});
  // A closed surface has three edges for two faces.
  mesh.edges.reserve(mesh.faces.size() + mesh.faces.size() / 2);
  mesh.edge_faces.begin.reserve(mesh.edges.capacity() + 1);
  mesh.edge_faces.entries.reserve(3 * mesh.faces.size());
  std::vector<Side> sides;
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    sides.clear();
    for (const std::uint32_t face : mesh.vertex_faces.row(vertex)) {
      const TriangleIndices& corners = mesh.faces[face];
      for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t from = corners[corner], to = corners[(corner + 1) % 3];
        if (std::min(from, to) == vertex) sides.push_back({std::max(from, to), face, corner});
      }
    }
    std::ranges::sort(sides);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (i == 0 || sides[i].higher_vertex != sides[i - 1].higher_vertex) {
        mesh.edges.push_back({vertex, sides[i].higher_vertex});
        mesh.edge_faces.begin.push_back(mesh.edge_faces.begin.back());
      }
      mesh.edge_faces.entries.push_back(sides[i].face);
      ++mesh.edge_faces.begin.back();
      mesh.face_edges[sides[i].face][sides[i].corner] = static_cast<std::uint32_t>(mesh.edges.size() - 1);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> first_at_place(std::span<const glm::dvec3> positions_m) {
  std::vector<std::uint32_t> order(positions_m.size()), first(positions_m.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t i) {
    const glm::dvec3& p = positions_m[i];
    return std::tie(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return place(a) < place(b) || (place(a) == place(b) && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || place(order[i]) != place(order[i - 1]);
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

MeshNeighbours mesh_neighbours(std::size_t vertex_count, std::vector<TriangleIndices> faces) {
  require_valid(vertex_count, faces);
  MeshNeighbours mesh;
  mesh.faces = std::move(faces);
  mesh.vertex_faces = lists_of(vertex_count, mesh.faces.size(), [&](std::size_t face, const auto& add) {
    if (!has_three_corners(mesh.faces[face])) return;
    for (const std::uint32_t vertex : mesh.faces[face]) add(vertex);
  });
  find_edges(mesh);
  mesh.vertex_edges = lists_of(vertex_count, mesh.edges.size(), [&](std::size_t edge, const auto& add) {
    for (const std::uint32_t vertex : mesh.edges[edge]) add(vertex);
  });
  mesh.neighbours.reserve(mesh.vertex_edges.entries.size());
  for (std::uint32_t vertex = 0; vertex < vertex_count; ++vertex) {
    for (const std::uint32_t edge : mesh.vertex_edges.row(vertex)) {
      const auto& [a, b] = mesh.edges[edge];
      mesh.neighbours.push_back(a == vertex ? b : a);
    }
  }
  return mesh;
}

std::vector<TriangleIndices> welded_faces(std::span<const TriangleIndices> faces,
                                          std::span<const std::uint32_t> first) {
  std::vector<TriangleIndices> welded(faces.begin(), faces.end());
  for (TriangleIndices& face : welded) {
    for (std::uint32_t& vertex : face) vertex = vertex < first.size() ? first[vertex] : vertex;
  }
  return welded;
}

}  // namespace offing
