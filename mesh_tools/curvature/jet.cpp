// SPDX-License-Identifier: GPL-3.0-or-later (CGAL's fit of jets)
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include "host/base/parallel_for.h"
#include "mesh_tools/curvature/bend_sink.h"

namespace offing::mesh_tools {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Fitting = CGAL::Monge_via_jet_fitting<Kernel>;

constexpr int degree = 2;
constexpr std::size_t least_points = 6;  // a quadratic's coefficients
constexpr int rings = 2, most_rings = 8;

Kernel::Vector_3 vector_of(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}
glm::dvec3 vector_of(const Kernel::Vector_3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Vertices within rings of edges about a vertex, itself first.
class Rings {
 public:
  explicit Rings(const MeshNeighbours& mesh)
      : mesh_(mesh), marks_(mesh.vertex_count(), MeshNeighbours::none) {}

  /// Two rings, or more until a quadratic can be fitted.
  const std::vector<std::uint32_t>& about(std::uint32_t vertex) {
    found_.assign(1, vertex);
    marks_[vertex] = vertex;
    std::size_t begin = 0;
    for (int ring = 0; ring < most_rings && (ring < rings || found_.size() < least_points); ++ring) {
      const std::size_t end = found_.size();
      for (std::size_t i = begin; i < end; ++i) {
        for (const std::uint32_t edge : mesh_.vertex_edges.row(found_[i])) {
          for (const std::uint32_t other : mesh_.edges[edge]) {
            if (marks_[other] == vertex) continue;
            marks_[other] = vertex;
            found_.push_back(other);
          }
        }
      }
      begin = end;
    }
    return found_;
  }

 private:
  const MeshNeighbours& mesh_;
  std::vector<std::uint32_t> marks_, found_;
};

/// CGAL's heights are along the normal, so that what bulges outward has negative curvatures there.
VertexBend fitted_bend(std::vector<Kernel::Point_3>& points, const glm::dvec3& outward) {
  Fitting fitting;
  auto form = fitting(points.begin(), points.end(), degree, degree);
  form.comply_wrt_given_normal(vector_of(outward));
  return {.k_max = -form.principal_curvatures(1),
          .k_min = -form.principal_curvatures(0),
          .e_max = vector_of(form.minimal_principal_direction()),
          .e_min = -vector_of(form.maximal_principal_direction()),
          .normal = vector_of(form.normal_direction())};
}

}  // namespace

void jet_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, int threads, const BendSink& sink) {
  parallel_chunks(mesh.vertex_count(), threads, [&](ChunkQueue& queue) {
    Rings around(mesh.neighbours);
    std::vector<Kernel::Point_3> points;
    queue.drain([&](std::size_t vertex) {
      if (mesh.neighbours.vertex_faces.row(vertex).empty() || measures.normals[vertex] == glm::dvec3(0.0))
        return sink.put(vertex, {});
      points.clear();
      for (const std::uint32_t other : around.about(static_cast<std::uint32_t>(vertex))) {
        const glm::dvec3& p = mesh.positions[other];
        points.emplace_back(p.x, p.y, p.z);
      }
      sink.put(vertex,
               points.size() >= least_points ? fitted_bend(points, measures.normals[vertex]) : VertexBend{});
    });
  });
}

}  // namespace offing::mesh_tools
