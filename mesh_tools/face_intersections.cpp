// SPDX-License-Identifier: GPL-3.0-or-later (CGAL)
#include "mesh_tools/face_intersections.h"

#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include "host/base/mesh_neighbours.h"

namespace offing::mesh_tools {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle = Kernel::Triangle_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

Point point_of(const glm::dvec3& position) {
  return {position.x, position.y, position.z};
}

/// Faces whose vertices at one place have one number.
class PlacedFaces {
 public:
  explicit PlacedFaces(const TriangleMesh& mesh) : mesh_(mesh), first_(first_at_place(mesh.positions_m)) {}

  bool intersect(std::uint32_t a, std::uint32_t b) const {
    TriangleIndices f = places_of(a), g = places_of(b);
    // Corners that both share come first, in the same order.
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = std::find(g.begin() + static_cast<int>(shared), g.end(), f[i]);
      if (found == g.end()) continue;
      std::iter_swap(found, g.begin() + static_cast<int>(shared));
      std::swap(f[i], f[shared]);
      ++shared;
    }
    switch (shared) {
      case 0:
        return CGAL::do_intersect(triangle(f), triangle(g));
      case 1:
        return CGAL::do_intersect(triangle(f), Segment(point(g[1]), point(g[2]))) ||
               CGAL::do_intersect(triangle(g), Segment(point(f[1]), point(f[2])));
      case 2:
        return CGAL::coplanar(point(f[0]), point(f[1]), point(f[2]), point(g[2])) &&
               CGAL::coplanar_orientation(point(f[0]), point(f[1]), point(f[2]), point(g[2])) ==
                   CGAL::POSITIVE;
      default:
        return !are_duplicates(mesh_.faces[a], mesh_.faces[b]);
    }
  }

 private:
  static bool are_duplicates(TriangleIndices f, TriangleIndices g) {
    std::sort(f.begin(), f.end());
    std::sort(g.begin(), g.end());
    return f == g;
  }

  TriangleIndices places_of(std::uint32_t face) const {
    const TriangleIndices& corners = mesh_.faces[face];
    return {first_[corners[0]], first_[corners[1]], first_[corners[2]]};
  }
  Point point(std::uint32_t vertex) const { return point_of(mesh_.positions_m[vertex]); }
  Triangle triangle(const TriangleIndices& corners) const {
    return {point(corners[0]), point(corners[1]), point(corners[2])};
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> first_;
};

}  // namespace

bool has_no_area(const TriangleMesh& mesh, const TriangleIndices& face) {
  return CGAL::collinear(point_of(mesh.positions_m[face[0]]), point_of(mesh.positions_m[face[1]]),
                         point_of(mesh.positions_m[face[2]]));
}

std::size_t count_faces_without_area(const TriangleMesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.faces.begin(), mesh.faces.end(),
                                                [&](const auto& face) { return has_no_area(mesh, face); }));
}

std::vector<std::array<std::uint32_t, 2>> intersecting_faces(const TriangleMesh& mesh,
                                                             const CancelToken& cancel) {
  const PlacedFaces faces(mesh);
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    if (has_no_area(mesh, mesh.faces[i])) continue;
    CGAL::Bbox_3 bounds;
    for (const std::uint32_t vertex : mesh.faces[i]) bounds += point_of(mesh.positions_m[vertex]).bbox();
    boxes.emplace_back(bounds, i);
  }
  std::vector<const Box*> pointers;
  for (const Box& box : boxes) pointers.push_back(&box);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto test = [&](const Box* a, const Box* b) {
    cancel.throw_if_cancelled();
    const auto [low, high] = std::minmax({a->info(), b->info()});
    if (faces.intersect(low, high)) pairs.push_back({low, high});
  };
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), test);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace offing::mesh_tools
