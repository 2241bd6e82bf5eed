#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "host/base/parallel_for.h"
#include "mesh_tools/curvature/bend_sink.h"
#include "mesh_tools/curvature/vertex_region.h"

namespace offing::mesh_tools {
namespace {

/// How far a line start + t * along lies within a ball of squared radius about the origin, within t = 0
/// ... 1.
struct Chord {
  double enter = 0.0, leave = 0.0;  ///< leave <= enter: not at all
};

template <typename Vector>
Chord chord(const Vector& start, const Vector& along, double radius_squared) {
  const double a = glm::dot(along, along), b = glm::dot(start, along),
               c = glm::dot(start, start) - radius_squared;
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0) || !(a > 0.0)) return {};
  const double root = std::sqrt(discriminant);
  return {std::max(0.0, (-b - root) / a), std::min(1.0, (-b + root) / a)};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Area of the circle about the origin within the triangle (origin, from, to); negative clockwise.
double sector_area(const glm::dvec2& from, const glm::dvec2& to, double radius_squared) {
  const auto sector = [&](const glm::dvec2& a, const glm::dvec2& b) {
    return 0.5 * radius_squared * std::atan2(cross(a, b), glm::dot(a, b));
  };
  const Chord inside = chord(from, to - from, radius_squared);
  if (!(inside.leave > inside.enter)) return sector(from, to);
  const glm::dvec2 in = from + inside.enter * (to - from), out = from + inside.leave * (to - from);
  return (inside.enter > 0.0 ? sector(from, in) : 0.0) + 0.5 * cross(in, out) +
         (inside.leave < 1.0 ? sector(out, to) : 0.0);
}

/// Area of a triangle within a ball about the origin.
double area_in_ball(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& normal,
                    double radius) {
  const double height = glm::dot(normal, a);
  const double radius_squared = radius * radius - height * height;
  if (!(radius_squared > 0.0)) return 0.0;
  const TangentFrame frame(normal);
  const auto flat = [&](const glm::dvec3& p) {
    return glm::dvec2(glm::dot(p, frame.u), glm::dot(p, frame.w));
  };
  const glm::dvec2 p = flat(a), q = flat(b), r = flat(c);
  return std::max(0.0, sector_area(p, q, radius_squared) + sector_area(q, r, radius_squared) +
                           sector_area(r, p, radius_squared));
}

}  // namespace

// H1 as its formula means it: |e in B| and |B| of the ball itself.
void clipped_tensor_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius, int threads,
                          const BendSink& sink) {
  parallel_chunks(mesh.vertex_count(), threads, [&](ChunkQueue& queue) {
    Region region(mesh);
    queue.drain([&](std::size_t vertex) {
      const glm::dvec3 middle = mesh.positions[vertex];
      SymmetricTensor tensor;
      double area = 0.0;
      const double rounding = 1e-12 * radius * radius;  // what sums of sectors outside the ball come to
      region.grow(
          static_cast<std::uint32_t>(vertex),
          [&](std::uint32_t face) {
            const TriangleIndices& corners = mesh.neighbours.faces[face];
            std::array<glm::dvec3, 3> at{};
            for (std::size_t i = 0; i < 3; ++i) at[i] = mesh.positions[corners[i]] - middle;
            if (!(measures.face_areas[face] > 0.0)) return false;
            const double inside = area_in_ball(at[0], at[1], at[2], measures.face_normals[face], radius);
            if (!(inside > rounding)) return false;
            area += inside;
            for (std::size_t i = 0; i < 3; ++i) {
              const Chord part = chord(at[i], at[(i + 1) % 3] - at[i], radius * radius);
              const double share = std::max(0.0, part.leave - part.enter);
              tensor += (0.5 * share) * edge_tensor(mesh, measures, mesh.neighbours.face_edges[face][i]);
            }
            return true;
          },
          [](std::uint32_t, bool is_in) { return is_in; });
      if (!(area > 0.0)) return sink.put(vertex, {});
      VertexBend bend = bend_of_tensor((1.0 / area) * tensor, measures.normals[vertex]);
      const double of_disc = 0.25 * radius * radius;
      straighten(bend, {of_disc, of_disc});
      sink.put(vertex, bend);
    });
  });
}

}  // namespace offing::mesh_tools
