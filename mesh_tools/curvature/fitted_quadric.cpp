#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "host/base/parallel_for.h"
#include "mesh_tools/curvature/bend_sink.h"
#include "mesh_tools/curvature/diffused_tensor.h"
#include "mesh_tools/curvature/vertex_region.h"

namespace offing::mesh_tools {
namespace {

/// Heights over a tangent plane: offset + tilt_u u + tilt_w w + (uu u^2 + 2 uw u w + ww w^2) / 2.
struct Quadric {
  double offset = 0.0, tilt_u = 0.0, tilt_w = 0.0, uu = 0.0, uw = 0.0, ww = 0.0;
};

constexpr std::size_t unknowns = 6;
constexpr std::size_t least_points = unknowns + 1;

/// Sums of weighted least squares.
class QuadricFit {
 public:
  void add(double u, double w, double height, double weight) {
    const std::array<double, unknowns> terms{1.0, u, w, 0.5 * u * u, u * w, 0.5 * w * w};
    std::size_t entry = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      const double weighted = weight * terms[i];
      for (std::size_t j = 0; j <= i; ++j) matrix_[entry++] += weighted * terms[j];
      right_[i] += weighted * height;
    }
  }

  /// By Cholesky's factors. False where points leave a coefficient open, such as all on a line.
  bool solve(Quadric& quadric) {
    // Below this part of its own sum a pivot is rounding.
    constexpr double least_pivot = 1e-10;
    const auto at = [&](std::size_t i, std::size_t j) -> double& { return matrix_[i * (i + 1) / 2 + j]; };
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = at(i, j);
        for (std::size_t k = 0; k < j; ++k) sum -= at(i, k) * at(j, k);
        if (i != j) {
          at(i, j) = sum / at(j, j);
        } else if (sum > least_pivot * at(i, i)) {
          at(i, i) = std::sqrt(sum);
        } else {
          return false;
        }
      }
    }
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t k = 0; k < i; ++k) right_[i] -= at(i, k) * right_[k];
      right_[i] /= at(i, i);
    }
    for (std::size_t i = unknowns; i-- > 0;) {
      for (std::size_t k = i + 1; k < unknowns; ++k) right_[i] -= at(k, i) * right_[k];
      right_[i] /= at(i, i);
    }
    quadric = {right_[0], right_[1], right_[2], right_[3], right_[4], right_[5]};
    return true;
  }

 private:
  std::array<double, unknowns*(unknowns + 1) / 2> matrix_{};  // the lower triangle, row by row
  std::array<double, unknowns> right_{};
};

/// Principal curvatures of the quadric where u = w = 0, over lengths of `radius`: eigenvalues of the second
/// fundamental form by the first, whose Cholesky factor makes a frame of the tangents orthonormal.
VertexBend bend_of(const Quadric& quadric, const TangentFrame& frame, const glm::dvec3& normal,
                   double radius) {
  const double fu = quadric.tilt_u, fw = quadric.tilt_w;
  const double slant = std::sqrt(1.0 + fu * fu + fw * fw), first = std::sqrt(1.0 + fu * fu);
  const double p = 1.0 / first, q = -fu * fw / (first * slant),
               r = first / slant;                // e1 = p Xu, e2 = q Xu + r Xw
  const double scale = -1.0 / (slant * radius);  // what falls away from the normal is convex
  const double l11 = scale * p * p * quadric.uu;
  const double l12 = scale * p * (q * quadric.uu + r * quadric.uw);
  const double l22 = scale * (q * q * quadric.uu + 2.0 * q * r * quadric.uw + r * r * quadric.ww);
  const PlaneEigen eigen = plane_eigen(l11, l12, l22);
  const glm::dvec3 along_u = frame.u + fu * normal, along_w = frame.w + fw * normal;
  VertexBend bend{.k_max = eigen.larger, .k_min = eigen.smaller};
  bend.e_max = glm::normalize((eigen.cosine * p + eigen.sine * q) * along_u + eigen.sine * r * along_w);
  bend.normal = (normal - fu * frame.u - fw * frame.w) / slant;
  bend.e_min = glm::cross(bend.normal, bend.e_max);
  return bend;
}

/// Fits a quadric to the vertices that a region holds within a radius. None where there are too few, or where
/// the surface is none over its tangent plane.
std::optional<VertexBend> fit(const UnitMesh& mesh, const SurfaceMeasures& measures, const Region& region,
                              double radius) {
  const std::uint32_t vertex = region.vertices().front();
  const glm::dvec3 &middle = mesh.positions[vertex], &normal = measures.normals[vertex];
  if (normal == glm::dvec3(0.0) || region.vertices().size() < least_points) return {};
  const TangentFrame frame(normal);
  QuadricFit sums;
  for (const std::uint32_t other : region.vertices()) {
    const glm::dvec3 off = (mesh.positions[other] - middle) / radius;
    const double u = glm::dot(off, frame.u), w = glm::dot(off, frame.w), height = glm::dot(off, normal);
    const double flat = u * u + w * w, chord = flat + height * height;
    // Falls smoothly to the rim, and to 0 for what faces away.
    const double facing = std::max(0.0, glm::dot(normal, measures.normals[other]));
    const double weight = (1.0 - chord) * (1.0 - chord) * facing;
    // A circle through the vertex has the height k chord^2 / 2 whatever the chord, but not k flat^2 / 2: over
    // chords, spheres are quadrics, and the bias of a fit of finite size goes.
    const double stretch = flat > 0.0 ? std::sqrt(chord / flat) : 1.0;
    sums.add(stretch * u, stretch * w, height, weight);
  }
  Quadric quadric;
  if (!sums.solve(quadric)) return {};
  constexpr double steepest = 1.7;  // 60 degrees
  if (!(quadric.tilt_u * quadric.tilt_u + quadric.tilt_w * quadric.tilt_w < steepest * steepest)) return {};
  return bend_of(quadric, frame, normal, radius);
}

}  // namespace

// Where edges are longer than most, the ball is widened until it holds enough vertices; where nothing can be
// fitted, tensors answer.
void fitted_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, double radius, int threads,
                  const BendSink& sink) {
  constexpr int most_tries = 3;
  std::vector<std::uint8_t> is_open(mesh.vertex_count(), 0);
  parallel_chunks(mesh.vertex_count(), threads, [&](ChunkQueue& queue) {
    Region region(mesh);
    queue.drain([&](std::size_t vertex) {
      std::optional<VertexBend> bend;
      double reach = radius;
      for (int i = 0; i < most_tries && !bend && measures.areas[vertex] > 0.0; ++i, reach *= 2.0) {
        region.grow_vertices(static_cast<std::uint32_t>(vertex), reach);
        bend = fit(mesh, measures, region, reach);
      }
      if (bend || !(measures.areas[vertex] > 0.0)) return sink.put(vertex, bend.value_or(VertexBend{}));
      is_open[vertex] = 1;
    });
  });
  if (std::ranges::find(is_open, 1) == is_open.end()) return;
  const DiffusedTensor others(mesh, measures, 1, threads);
  for (std::size_t i = 0; i < is_open.size(); ++i) {
    if (is_open[i] != 0) sink.put(i, others.bend_at(i));
  }
}

}  // namespace offing::mesh_tools
