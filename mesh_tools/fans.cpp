#include "mesh_tools/fans.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "host/base/disjoint_sets.h"
#include "mesh_tools/edge_table.h"

namespace offing::mesh_tools {

namespace {

struct AngledUse {
  double angle_rad;  ///< of the face around the edge
  const EdgeUse* use;
};

/// The faces of an edge in the order in which they come around it, anticlockwise seen against its direction
/// from the lower to the higher vertex.
std::vector<AngledUse> around(const TriangleMesh& mesh, std::span<const EdgeUse> uses) {
  const glm::dvec3 low = mesh.positions_m[uses[0].low], axis = mesh.positions_m[uses[0].high] - low;
  std::vector<AngledUse> order;
  glm::dvec3 u(0.0), v(0.0);
  for (const EdgeUse& use : uses) {
    const TriangleIndices& face = mesh.faces[use.face];
    const std::uint32_t third = face[0] ^ face[1] ^ face[2] ^ use.low ^ use.high;
    const glm::dvec3 side = glm::cross(axis, mesh.positions_m[third] - low);  // a quarter ahead of the face
    if (order.empty()) {
      u = side;
      v = glm::cross(axis, side) / std::max(glm::length(axis), 1e-300);
    }
    order.push_back({std::atan2(glm::dot(side, v), glm::dot(side, u)), &use});
  }
  std::sort(order.begin(), order.end(), [](const AngledUse& a, const AngledUse& b) {
    return std::tie(a.angle_rad, a.use->face) < std::tie(b.angle_rad, b.use->face);
  });
  return order;
}

/// Calls `join` with the faces of an edge that belong together: two if they agree. Of more, a face that runs
/// from the lower to the higher vertex has its outside ahead, as angles grow, and its inside behind: it
/// belongs to the one behind it if that has its inside ahead.
template <typename Join>
void for_each_pair(const TriangleMesh& mesh, std::span<const EdgeUse> uses, Join join) {
  if (uses.size() == 2 && uses[0].way != uses[1].way) join(uses[0], uses[1]);
  if (uses.size() <= 2) return;
  const std::vector<AngledUse> order = around(mesh, uses);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const EdgeUse& use = *order[i].use;
    const EdgeUse& behind = *order[(i + order.size() - 1) % order.size()].use;
    if (use.way == EdgeUse::Way::low_to_high && behind.way == EdgeUse::Way::high_to_low) join(use, behind);
  }
}

}  // namespace

void turn_in_breadth(TriangleMesh& mesh, std::vector<std::uint8_t>& is_turned) {
  struct Neighbour {
    std::uint32_t face, other;
    std::uint8_t disagrees;
  };
  std::vector<Neighbour> neighbours;
  EdgeTable(mesh.faces).for_each_edge([&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const std::uint8_t disagrees = uses[0].way == uses[1].way ? 1 : 0;
    neighbours.push_back({uses[0].face, uses[1].face, disagrees});
    neighbours.push_back({uses[1].face, uses[0].face, disagrees});
  });
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::tie(a.face, a.other) < std::tie(b.face, b.other);
  });
  std::vector<std::uint8_t> is_reached(mesh.faces.size(), 0);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t seed = 0; seed < mesh.faces.size(); ++seed) {
    if (is_reached[seed] != 0) continue;
    is_reached[seed] = 1;
    queue.assign(1, seed);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t face = queue[next];
      const auto first = std::lower_bound(neighbours.begin(), neighbours.end(), face,
                                          [](const Neighbour& n, std::uint32_t f) { return n.face < f; });
      for (auto n = first; n != neighbours.end() && n->face == face; ++n) {
        if (std::exchange(is_reached[n->other], 1) != 0) continue;
        is_turned[n->other] = is_turned[face] ^ n->disagrees;
        queue.push_back(n->other);
      }
    }
  }
  for (std::size_t i = 0; i < is_turned.size(); ++i) {
    if (is_turned[i] != 0) std::swap(mesh.faces[i][1], mesh.faces[i][2]);
  }
}

void take_fans_apart(TriangleMesh& mesh) {
  DisjointSets corners(3 * mesh.faces.size());
  EdgeTable(mesh.faces).for_each_edge([&](std::span<const EdgeUse> uses) {
    for_each_pair(mesh, uses, [&](const EdgeUse& a, const EdgeUse& b) {
      for (const std::uint32_t vertex : {a.low, a.high}) {
        corners.join(corner_at(mesh.faces, a.face, vertex), corner_at(mesh.faces, b.face, vertex));
      }
    });
  });
  std::vector<std::uint8_t> is_taken(mesh.positions_m.size(), 0);
  std::vector<std::uint32_t> vertex_of(3 * mesh.faces.size());  // of the first corner of each fan
  for (std::uint32_t corner = 0; corner < vertex_of.size(); ++corner) {
    std::uint32_t& vertex = mesh.faces[corner / 3][corner % 3];
    const std::uint32_t root = corners.root_of(corner).index;  // the fan's first corner
    if (root == corner) {
      vertex_of[corner] = vertex;
      if (std::exchange(is_taken[vertex], 1) != 0) {
        vertex_of[corner] = static_cast<std::uint32_t>(mesh.positions_m.size());
        mesh.positions_m.push_back(mesh.positions_m[vertex]);
      }
    }
    vertex = vertex_of[root];
  }
}

}  // namespace offing::mesh_tools
