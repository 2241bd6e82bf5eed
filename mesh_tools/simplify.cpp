// SPDX-License-Identifier: GPL-3.0-or-later (CGAL)
#include "mesh_tools/simplify.h"

#include <algorithm>
#include <limits>

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "host/base/progress.h"
#include "mesh_tools/surface.h"

namespace offing::mesh_tools {

namespace {

namespace sms = CGAL::Surface_mesh_simplification;

/// Lets collapses be stopped and followed.
class Watch : public sms::Edge_collapse_visitor_base<Surface> {
 public:
  Watch(const CancelToken& cancel, Progress& progress, std::size_t collapses)
      : cancel_(&cancel), progress_(&progress), collapses_left_(collapses) {}

  /// A cost is a boost::optional in CGAL 5 and a std::optional in CGAL 6.
  template <class Cost>
  // NOLINTNEXTLINE(readability-identifier-naming): the name is CGAL's
  void OnSelected(const Profile& /*edge*/, const Cost& /*cost*/, std::size_t /*initial*/,
                  std::size_t /*current*/) {
    cancel_->throw_if_cancelled();
    if (collapses_left_ == 0) return;
    --collapses_left_;
    progress_->advance();
  }

 private:
  const CancelToken* cancel_;
  Progress* progress_;
  std::size_t collapses_left_;
};

int progress_steps(std::size_t collapses) {
  return static_cast<int>(std::min<std::size_t>(collapses, std::numeric_limits<int>::max()));
}

/// A collapse of an inner edge takes two faces.
class FewFaces {
 public:
  FewFaces(const Surface& surface, std::size_t most) : surface_(&surface), most_(most) {}

  template <typename Cost, typename Profile>
  bool operator()(const Cost& /*cost*/, const Profile& /*edge*/, std::size_t /*initial*/,
                  std::size_t /*current*/) const {
    return surface_->number_of_faces() <= most_;
  }

 private:
  const Surface* surface_;
  std::size_t most_;
};

}  // namespace

TriangleMesh simplify_to_faces(const TriangleMesh& mesh, std::string_view file_name, std::size_t faces,
                               const CancelToken& cancel, Verbosity verbosity) {
  Surface surface = to_surface(mesh, file_name);
  // A collapse takes two faces, on a border one.
  const std::size_t collapses = (mesh.faces.size() - std::min(mesh.faces.size(), faces)) / 2;
  Progress progress(progress_steps(collapses), "collapses", verbosity);
  const sms::GarlandHeckbert_plane_policies<Surface, Kernel> quadrics(surface);
  sms::edge_collapse(surface, FewFaces(surface, faces),
                     CGAL::parameters::get_cost(quadrics.get_cost())
                         .get_placement(quadrics.get_placement())
                         .filter(sms::Bounded_normal_change_filter<>())
                         .visitor(Watch(cancel, progress, collapses)));
  return to_mesh(surface);
}

TriangleMesh simplify_to_edges(const TriangleMesh& mesh, std::string_view file_name, double edge_m,
                               const CancelToken& cancel, Verbosity verbosity) {
  Surface surface = to_surface(mesh, file_name);
  // A vertex goes with each collapse, and with it three edges, of which about one was short.
  const auto edges = surface.edges();
  const auto short_edges = std::count_if(edges.begin(), edges.end(), [&](Surface::Edge_index edge) {
    const Surface::Halfedge_index half = surface.halfedge(edge);
    return CGAL::squared_distance(surface.point(surface.source(half)), surface.point(surface.target(half))) <
           edge_m * edge_m;
  });
  const auto collapses = static_cast<std::size_t>(short_edges) / 3;
  Progress progress(progress_steps(collapses), "collapses", verbosity);
  sms::edge_collapse(surface, sms::Edge_length_stop_predicate<double>(edge_m),
                     CGAL::parameters::get_cost(sms::Edge_length_cost<Surface>())
                         .get_placement(sms::Midpoint_placement<Surface>())
                         .filter(sms::Bounded_normal_change_filter<>())
                         .visitor(Watch(cancel, progress, collapses)));
  return to_mesh(surface);
}

}  // namespace offing::mesh_tools
