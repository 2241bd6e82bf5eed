// SPDX-License-Identifier: GPL-3.0-or-later (CGAL)
#include "mesh_tools/repair.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <glm/geometric.hpp>

#include "host/base/disjoint_sets.h"
#include "host/base/error.h"
#include "host/base/mesh_neighbours.h"
#include "host/base/triangle_mesh.h"
#include "mesh_tools/edge_table.h"
#include "mesh_tools/surface.h"

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

/// Turns faces so that neighbours at edges of two agree, in breadth from the first face of each part: where a
/// one-sided surface forbids it, the seam is short. is_turned [faces] is 1 for those that were turned.
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

/// Takes vertices apart so that only corners stay together whose faces are neighbours: two at an edge that
/// agree, or, of more at an edge, those that have the inside of one solid between them. The first fan of a
/// vertex keeps it, others get copies behind the last vertex.
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

namespace pmp = CGAL::Polygon_mesh_processing;

using Halfedge = Surface::Halfedge_index;

void require_faces(const TriangleMesh& mesh) {
  if (!mesh.faces.empty()) return;
  throw Error(ErrorKind::bad_input, "repair: expected faces with an area, got none",
              "`offing-mesh check` shows what the mesh contains");
}

/// Only on borders: what is closed already and touches another part stays apart.
std::size_t merge_seams(TriangleMesh& mesh) {
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint8_t> is_on_border(mesh.positions_m.size(), 0);
  EdgeTable(mesh.faces).for_each_edge([&](std::span<const EdgeUse> uses) {
    if (uses.size() == 1) is_on_border[uses[0].low] = is_on_border[uses[0].high] = 1;
  });
  const std::vector<std::uint32_t> first = first_at_place(mesh.positions_m);
  std::vector<std::uint32_t> kept(mesh.positions_m.size(), none);  // by the first at the place
  std::vector<std::uint32_t> target(mesh.positions_m.size());
  std::size_t merged = 0;
  for (std::uint32_t i = 0; i < target.size(); ++i) {
    target[i] = i;
    if (is_on_border[i] == 0) continue;
    std::uint32_t& vertex = kept[first[i]];
    if (vertex == none) vertex = i;
    target[i] = vertex;
    merged += vertex != i;
  }
  for (TriangleIndices& face : mesh.faces) {
    for (std::uint32_t& vertex : face) vertex = target[vertex];
  }
  return merged;
}

std::size_t remove_repeating_faces(TriangleMesh& mesh) {
  return std::erase_if(mesh.faces, repeats_vertex);
}

/// The first of each three vertices stays.
std::size_t remove_duplicate_faces(TriangleMesh& mesh) {
  std::vector<std::pair<TriangleIndices, std::size_t>> sorted;
  for (const TriangleIndices& face : mesh.faces) {
    sorted.emplace_back(face, sorted.size());
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint8_t> is_repeated(sorted.size(), 0);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    is_repeated[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < is_repeated.size(); ++i) {
    if (is_repeated[i] == 0) mesh.faces[kept++] = mesh.faces[i];
  }
  mesh.faces.resize(kept);
  return is_repeated.size() - kept;
}

/// How a face lies beside how it came; those of filled holes came no way.
enum class FaceTurn : std::uint8_t { none, as_was, turned };

struct TurnRecorder : pmp::Default_orientation_visitor {
  std::vector<std::uint8_t>* is_turned;
  void polygon_orientation_reversed(std::size_t face) { (*is_turned)[face] ^= 1; }
};

/// Components whose faces were turned for the greater part are turned back.
void turn_to_majority(TriangleMesh& mesh, std::vector<std::uint8_t>& is_turned) {
  DisjointSets components(mesh.faces.size());
  EdgeTable(mesh.faces).for_each_edge([&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses) components.join(uses[0].face, use.face);
  });
  std::vector<std::int64_t> votes(mesh.faces.size(), 0);
  for (std::uint32_t i = 0; i < is_turned.size(); ++i) {
    votes[components.root_of(i).index] += is_turned[i] != 0 ? 1 : -1;
  }
  for (std::uint32_t i = 0; i < is_turned.size(); ++i) {
    if (votes[components.root_of(i).index] <= 0) continue;
    std::swap(mesh.faces[i][1], mesh.faces[i][2]);
    is_turned[i] ^= 1;
  }
}

/// Which faces are turned now, [faces].
std::vector<std::uint8_t> orient(TriangleMesh& mesh, RepairChanges& changes) {
  const std::size_t vertices_before = mesh.positions_m.size();
  std::vector<std::uint8_t> is_turned(mesh.faces.size(), 0);
  turn_in_breadth(mesh, is_turned);
  take_fans_apart(mesh);
  // A fan that meets itself at an edge of three faces is left to CGAL.
  std::vector<Kernel::Point_3> points;
  for (const glm::dvec3& p : mesh.positions_m) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::vector<std::size_t>> polygons;
  for (const TriangleIndices& face : mesh.faces) polygons.push_back({face[0], face[1], face[2]});
  TurnRecorder recorder;
  recorder.is_turned = &is_turned;
  pmp::orient_polygon_soup(points, polygons, CGAL::parameters::visitor(recorder));
  changes.split_vertices += points.size() - vertices_before;
  for (std::size_t i = mesh.positions_m.size(); i < points.size(); ++i) {
    mesh.positions_m.emplace_back(points[i].x(), points[i].y(), points[i].z());
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      mesh.faces[i][corner] = static_cast<std::uint32_t>(polygons[i][corner]);
    }
  }
  turn_to_majority(mesh, is_turned);
  return is_turned;
}

/// Closed components whose volume is negative are turned over.
void face_outward(TriangleMesh& mesh, std::vector<FaceTurn>& turns) {
  DisjointSets components(mesh.faces.size());
  std::vector<std::uint8_t> is_open(mesh.faces.size(), 0);
  const EdgeTable edges(mesh.faces);
  edges.for_each_edge([&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses) components.join(uses[0].face, use.face);
  });
  edges.for_each_edge([&](std::span<const EdgeUse> uses) {
    if (uses.size() == 1) is_open[components.root_of(uses[0].face).index] = 1;
  });
  std::vector<double> volumes(mesh.faces.size(), 0.0);
  const glm::dvec3 origin = mesh.positions_m[mesh.faces[0][0]];
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    const TriangleIndices& face = mesh.faces[i];
    const glm::dvec3 a = mesh.positions_m[face[0]] - origin, b = mesh.positions_m[face[1]] - origin,
                     c = mesh.positions_m[face[2]] - origin;
    volumes[components.root_of(i).index] += glm::dot(a, glm::cross(b, c));
  }
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    const std::uint32_t root = components.root_of(i).index;
    if (is_open[root] != 0 || volumes[root] >= 0.0) continue;
    std::swap(mesh.faces[i][1], mesh.faces[i][2]);
    if (turns[i] != FaceTurn::none)
      turns[i] = turns[i] == FaceTurn::as_was ? FaceTurn::turned : FaceTurn::as_was;
  }
}

double area_m2(const Surface& surface, Surface::Face_index face) {
  const Halfedge edge = surface.halfedge(face);
  const auto& a = surface.point(surface.source(edge));
  const auto& b = surface.point(surface.target(edge));
  const auto& c = surface.point(surface.target(surface.next(edge)));
  return 0.5 * std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
}

/// Fills loops one by one. What would cover half as much as its component, such as the outer border of a
/// small patch, is no hole.
class HoleFiller {
 public:
  HoleFiller(Surface& surface, const RepairSettings& settings)
      : surface_(surface),
        settings_(settings),
        component_(surface.add_property_map<Surface::Face_index, std::size_t>("f:component", 0).first) {
    areas_m2_.resize(pmp::connected_components(surface, component_), 0.0);
    for (const Surface::Face_index face : surface.faces()) {
      areas_m2_[component_[face]] += area_m2(surface, face);
    }
  }

  /// How many faces were added: 0 if the loop stays open.
  std::size_t fill(Halfedge loop) {
    int edges = 0;
    for ([[maybe_unused]] const Halfedge edge : CGAL::halfedges_around_face(loop, surface_)) ++edges;
    if (edges > settings_.most_hole_edges) return 0;
    const std::size_t component = component_[surface_.face(surface_.opposite(loop))];
    std::vector<Surface::Face_index> patch;
    pmp::triangulate_hole(surface_, loop, std::back_inserter(patch));
    double patch_m2 = 0.0;
    for (const Surface::Face_index face : patch) patch_m2 += area_m2(surface_, face);
    if (2.0 * patch_m2 < areas_m2_[component]) return patch.size();
    for (const Surface::Face_index face : patch) CGAL::Euler::remove_face(surface_.halfedge(face), surface_);
    return 0;
  }

 private:
  Surface& surface_;
  const RepairSettings& settings_;
  Surface::Property_map<Surface::Face_index, std::size_t> component_;
  std::vector<double> areas_m2_;
};

void fill_holes(Surface& surface, const RepairSettings& settings, const CancelToken& cancel,
                RepairChanges& changes) {
  std::vector<Halfedge> loops;
  pmp::extract_boundary_cycles(surface, std::back_inserter(loops));
  HoleFiller filler(surface, settings);
  for (const Halfedge loop : loops) {
    cancel.throw_if_cancelled();
    const std::size_t added = filler.fill(loop);
    changes.added_faces += added;
    ++(added == 0 ? changes.open_loops : changes.filled_holes);
  }
}

std::size_t remove_isolated_vertices(TriangleMesh& mesh) {
  std::vector<std::uint32_t> numbers(mesh.positions_m.size(), 0);
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t vertex : face) numbers[vertex] = 1;
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == 0) continue;
    numbers[i] = kept;
    mesh.positions_m[kept++] = mesh.positions_m[i];
  }
  for (TriangleIndices& face : mesh.faces) {
    for (std::uint32_t& vertex : face) vertex = numbers[vertex];
  }
  const std::size_t removed = mesh.positions_m.size() - kept;
  mesh.positions_m.resize(kept);
  return removed;
}

}  // namespace

RepairChanges repair(TriangleMesh& mesh, const RepairSettings& settings, const CancelToken& cancel) {
  RepairChanges changes;
  mesh.normals.clear();
  changes.merged_vertices = merge_seams(mesh);
  changes.removed_repeating_faces = remove_repeating_faces(mesh);
  changes.removed_duplicate_faces = remove_duplicate_faces(mesh);
  require_faces(mesh);
  cancel.throw_if_cancelled();
  const std::vector<std::uint8_t> is_turned = orient(mesh, changes);
  cancel.throw_if_cancelled();

  // CGAL's surfaces have no vertices without faces; merged vertices have been counted.
  changes.removed_vertices = remove_isolated_vertices(mesh) - changes.merged_vertices;
  Surface surface = to_surface(mesh, "repair");
  auto turn_of = surface.add_property_map<Surface::Face_index, FaceTurn>("f:turn", FaceTurn::none).first;
  for (const Surface::Face_index face : surface.faces()) {
    turn_of[face] = is_turned[face] != 0 ? FaceTurn::turned : FaceTurn::as_was;
  }
  const std::size_t faces_before = surface.number_of_faces(), vertices_before = surface.number_of_vertices();
  pmp::remove_degenerate_faces(surface);
  changes.collapsed_vertices = vertices_before - surface.number_of_vertices();
  changes.split_vertices += pmp::duplicate_non_manifold_vertices(surface);
  changes.removed_degenerate_faces = faces_before - surface.number_of_faces();
  cancel.throw_if_cancelled();
  fill_holes(surface, settings, cancel, changes);
  mesh = to_mesh(surface);
  std::vector<FaceTurn> turns;
  for (const Surface::Face_index face : surface.faces()) turns.push_back(turn_of[face]);
  require_faces(mesh);
  if (settings.facing == Facing::outward) face_outward(mesh, turns);
  changes.turned_faces = static_cast<std::size_t>(std::count(turns.begin(), turns.end(), FaceTurn::turned));
  return changes;
}

}  // namespace offing::mesh_tools
