#include "mesh_tools/mesh_defects.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "host/base/disjoint_sets.h"
#include "host/base/error.h"
#include "mesh_tools/edge_table.h"
#include "mesh_tools/face_intersections.h"

namespace offing::mesh_tools {
namespace {

/// Counts sets among the things that are marked.
std::size_t count_sets(DisjointSets& sets, const std::vector<std::uint8_t>& is_marked) {
  std::vector<std::uint8_t> has_root(is_marked.size(), 0);
  for (std::uint32_t i = 0; i < is_marked.size(); ++i) {
    if (is_marked[i] != 0) has_root[sets.root_of(i).index] = 1;
  }
  return static_cast<std::size_t>(std::count(has_root.begin(), has_root.end(), 1));
}

void count_vertices(const TriangleMesh& mesh, MeshDefects& defects) {
  DisjointSets sets(mesh.positions_m.size());
  std::vector<std::uint8_t> is_used(mesh.positions_m.size(), 0);
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t vertex : face) {
      is_used[vertex] = 1;
      sets.join(face[0], vertex);
    }
  }
  defects.components = count_sets(sets, is_used);
  defects.isolated_vertices = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 0));
}

std::size_t count_duplicates(const std::vector<TriangleIndices>& faces) {
  std::vector<TriangleIndices> sorted = faces;
  for (TriangleIndices& face : sorted) std::sort(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

/// Joins what lies around an edge, and counts the edge.
class EdgeCounter {
 public:
  EdgeCounter(const TriangleMesh& mesh, MeshDefects& defects)
      : faces_(mesh.faces),
        defects_(defects),
        border_(mesh.positions_m.size()),
        is_on_border_(mesh.positions_m.size(), 0),
        sides_(mesh.faces.size()),
        fans_(3 * mesh.faces.size()),
        fan_count_(mesh.positions_m.size(), 0) {}

  void add(std::span<const EdgeUse> uses) {
    const EdgeUse& first = uses.front();
    if (uses.size() == 1) {
      ++defects_.boundary_edges;
      border_.join(first.low, first.high);
      is_on_border_[first.low] = is_on_border_[first.high] = 1;
    } else if (uses.size() == 2) {
      const bool is_turned = first.way == uses.back().way;
      defects_.turned_edges += is_turned;
      using enum DisjointSets::Relation;
      if (!sides_.join(first.face, uses.back().face, is_turned ? turned : same)) defects_.orientable = false;
    } else {
      ++defects_.non_manifold_edges;
    }
    for (const EdgeUse& use : uses.subspan(1)) {
      for (const std::uint32_t vertex : {first.low, first.high}) {
        fans_.join(corner_at(faces_, first.face, vertex), corner_at(faces_, use.face, vertex));
      }
    }
  }

  void finish() {
    defects_.boundary_loops = count_sets(border_, is_on_border_);
    for (std::uint32_t corner = 0; corner < 3 * faces_.size(); ++corner) {
      const TriangleIndices& face = faces_[corner / 3];
      if (!repeats_vertex(face) && fans_.root_of(corner).index == corner) ++fan_count_[face[corner % 3]];
    }
    defects_.non_manifold_vertices = static_cast<std::size_t>(
        std::count_if(fan_count_.begin(), fan_count_.end(), [](std::uint32_t fans) { return fans > 1; }));
  }

 private:
  const std::vector<TriangleIndices>& faces_;
  MeshDefects& defects_;
  DisjointSets border_;  // of vertices
  std::vector<std::uint8_t> is_on_border_;
  DisjointSets sides_;  // of faces
  DisjointSets fans_;   // of corners
  std::vector<std::uint32_t> fan_count_;
};

}  // namespace

MeshDefects find_index_defects(const TriangleMesh& mesh) {
  MeshDefects defects;
  defects.vertices = mesh.positions_m.size();
  defects.faces = mesh.faces.size();
  count_vertices(mesh, defects);
  defects.duplicate_faces = count_duplicates(mesh.faces);
  defects.repeating_faces =
      static_cast<std::size_t>(std::count_if(mesh.faces.begin(), mesh.faces.end(), repeats_vertex));
  EdgeCounter counter(mesh, defects);
  EdgeTable(mesh.faces).for_each_edge([&](std::span<const EdgeUse> uses) { counter.add(uses); });
  counter.finish();
  return defects;
}

MeshDefects find_defects(const TriangleMesh& mesh, const CancelToken& cancel) {
  MeshDefects defects = find_index_defects(mesh);
  cancel.throw_if_cancelled();
  defects.degenerate_faces = count_faces_without_area(mesh);
  defects.self_intersections = intersecting_faces(mesh, cancel).size();
  return defects;
}

void require_manifold(const TriangleMesh& mesh, std::string_view file_name) {
  const MeshDefects defects = find_index_defects(mesh);
  const bool is_manifold = defects.non_manifold_edges == 0 && defects.non_manifold_vertices == 0 &&
                           defects.turned_edges == 0 && defects.repeating_faces == 0;
  if (is_manifold) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: expected a manifold, got {} edges of more than two faces, {} vertices of more than "
                  "one fan, {} edges at which faces disagree, {} faces that repeat a vertex",
                  one_line(file_name), defects.non_manifold_edges, defects.non_manifold_vertices,
                  defects.turned_edges, defects.repeating_faces),
      "repair it with `offing-mesh repair`");
}

}  // namespace offing::mesh_tools
