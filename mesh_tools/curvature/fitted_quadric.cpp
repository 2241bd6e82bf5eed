#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

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

/// Of a quadric, and with all terms up to the fourth power.
constexpr int quadric_degree = 2, quartic_degree = 4;

constexpr std::size_t terms_up_to(int degree) {
  return static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
}

/// Points as a fit takes them, over lengths of the radius: coordinates in the tangent plane, heights,
/// weights. Points without weight fill the last group of lanes.
struct FitPoints {
  static constexpr std::size_t lanes = 8;
  std::vector<double> u, w, height, weight;
  std::size_t count = 0;  ///< of those with weight

  void clear() {
    for (auto* values : {&u, &w, &height, &weight}) values->clear();
    count = 0;
  }
  void add(double point_u, double point_w, double point_height, double point_weight) {
    u.push_back(point_u);
    w.push_back(point_w);
    height.push_back(point_height);
    weight.push_back(point_weight);
    ++count;
  }
  void fill_lanes() {
    for (auto* values : {&u, &w, &height, &weight}) values->resize((count + lanes - 1) / lanes * lanes, 0.0);
  }
};

/// Sums of value u^i w^j over points, for all i + j up to a degree. They are summed in lanes, which a
/// compiler makes into vectors; the order is always the same.
template <int degree>
class Moments {
 public:
  Moments(const std::vector<double>& values, const FitPoints& points) {
    for (std::size_t begin = 0; begin < values.size(); begin += lanes) {
      const double *us = &points.u[begin], *ws = &points.w[begin];
      Lanes column;
      std::copy_n(&values[begin], lanes, column.begin());
      std::size_t entry = 0;
      for (int i = 0; i <= degree; ++i) {
        Lanes term = column;
        for (int j = 0; i + j <= degree; ++j, ++entry) {
          for (std::size_t lane = 0; lane < lanes; ++lane) sums_[entry][lane] += term[lane];
          for (std::size_t lane = 0; lane < lanes; ++lane) term[lane] *= ws[lane];
        }
        for (std::size_t lane = 0; lane < lanes; ++lane) column[lane] *= us[lane];
      }
    }
  }

  double at(int i, int j) const {
    const Lanes& sums = sums_[static_cast<std::size_t>(i * (2 * degree + 3 - i) / 2 + j)];
    return std::accumulate(sums.begin(), sums.end(), 0.0);
  }

 private:
  static constexpr std::size_t lanes = FitPoints::lanes;
  using Lanes = std::array<double, lanes>;
  std::array<Lanes, terms_up_to(degree)> sums_{};
};

/// A polynomial for heights, and the standard deviation of points off it.
template <int degree>
struct HeightFit {
  std::array<double, terms_up_to(degree)> coefficients;  ///< of a Quadric first
  double deviation;
};

/// Weighted least squares by Cholesky's factors. None where points leave a coefficient open, such as all on a
/// line.
template <int degree>
std::optional<HeightFit<degree>> height_fit(const FitPoints& points) {
  constexpr std::size_t unknowns = terms_up_to(degree);
  // Below this part of its own sum a pivot is rounding.
  constexpr double least_pivot = 1e-10;
  if (points.count <= unknowns) return {};
  const Moments<2 * degree> sums(points.weight, points);
  std::vector<double> weighted(points.weight.size());
  double rest = 0.0;  // of the heights' squares, in the end
  for (std::size_t i = 0; i < weighted.size(); ++i) {
    weighted[i] = points.weight[i] * points.height[i];
    rest += weighted[i] * points.height[i];
  }
  const Moments<degree> height_sums(weighted, points);

  struct Term {
    int i, j;
    double factor;
  };
  std::array<Term, unknowns> terms;
  std::size_t count = 0;
  for (int power = 0; power <= degree; ++power) {
    for (int j = 0; j <= power; ++j) terms[count++] = {power - j, j, power == 2 && j != 1 ? 0.5 : 1.0};
  }
  std::array<std::array<double, unknowns>, unknowns> matrix;  // its lower triangle
  std::array<double, unknowns> right;
  for (std::size_t i = 0; i < unknowns; ++i) {
    right[i] = terms[i].factor * height_sums.at(terms[i].i, terms[i].j);
    for (std::size_t j = 0; j <= i; ++j) {
      matrix[i][j] =
          terms[i].factor * terms[j].factor * sums.at(terms[i].i + terms[j].i, terms[i].j + terms[j].j);
    }
  }
  for (std::size_t i = 0; i < unknowns; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= matrix[i][k] * matrix[j][k];
      if (i != j) {
        matrix[i][j] = sum / matrix[j][j];
      } else if (sum > least_pivot * matrix[i][i]) {
        matrix[i][i] = std::sqrt(sum);
      } else {
        return {};
      }
    }
  }
  for (std::size_t i = 0; i < unknowns; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= matrix[i][k] * right[k];
    right[i] /= matrix[i][i];
    rest -= right[i] * right[i];
  }
  for (std::size_t i = unknowns; i-- > 0;) {
    for (std::size_t k = i + 1; k < unknowns; ++k) right[i] -= matrix[k][i] * right[k];
    right[i] /= matrix[i][i];
  }
  const double freedom = 1.0 - static_cast<double>(unknowns) / static_cast<double>(points.count);
  return HeightFit<degree>{right, std::sqrt(std::max(0.0, rest) / (sums.at(0, 0) * freedom))};
}

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

/// What fits go by: normals of vertices, and which vertices do not count, as a face there is folded over.
struct Support {
  std::vector<glm::dvec3> normals;
  std::vector<std::uint8_t> is_folded;
};

/// The faces around a vertex, as one vector; at a border, where these are few, those around its neighbours
/// too.
glm::dvec3 outward(const UnitMesh& mesh, const SurfaceMeasures& measures, std::uint32_t vertex) {
  if (mesh.on_border[vertex] == 0) return measures.normals[vertex];
  glm::dvec3 sum = measures.areas[vertex] * measures.normals[vertex];
  for (const std::uint32_t other : mesh.neighbours.neighbours_of(vertex))
    sum += measures.areas[other] * measures.normals[other];
  return glm::length(sum) > 0.0 ? glm::normalize(sum) : measures.normals[vertex];
}

/// A face is folded over where it looks away from the normals of its corners. Scans have such faces. These
/// are left out of their corners' normals too.
Support support_of(const UnitMesh& mesh, const SurfaceMeasures& measures) {
  Support support{measures.normals, std::vector<std::uint8_t>(mesh.vertex_count(), 0)};
  const auto is_folded = [&](std::uint32_t face) {
    const auto& [a, b, c] = mesh.neighbours.faces[face];
    const glm::dvec3 sum =
        outward(mesh, measures, a) + outward(mesh, measures, b) + outward(mesh, measures, c);
    return measures.face_areas[face] > 0.0 && glm::dot(measures.face_normals[face], sum) < 0.0;
  };
  for (std::uint32_t face = 0; face < mesh.neighbours.faces.size(); ++face) {
    if (!is_folded(face)) continue;
    for (const std::uint32_t corner : mesh.neighbours.faces[face]) support.is_folded[corner] = 1;
  }
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (support.is_folded[vertex] == 0) continue;
    glm::dvec3 sum(0.0);
    for (const std::uint32_t face : mesh.neighbours.vertex_faces.row(vertex)) {
      if (!is_folded(face)) sum += measures.face_areas[face] * measures.face_normals[face];
    }
    support.normals[vertex] = glm::length(sum) > 0.0 ? glm::normalize(sum) : outward(mesh, measures, vertex);
  }
  return support;
}

/// The vertices of a region that count, about its first one.
void take_points(const UnitMesh& mesh, const Support& support, const Region& region,
                 const TangentFrame& frame, double radius, FitPoints& points) {
  const std::uint32_t vertex = region.vertices().front();
  const glm::dvec3 &middle = mesh.positions[vertex], &normal = support.normals[vertex];
  const double per_radius = 1.0 / radius;
  points.clear();
  for (const std::uint32_t other : region.vertices()) {
    if (support.is_folded[other] != 0) continue;
    const glm::dvec3 off = per_radius * (mesh.positions[other] - middle);
    const double u = glm::dot(off, frame.u), w = glm::dot(off, frame.w), height = glm::dot(off, normal);
    const double flat = u * u + w * w, chord = flat + height * height;
    // Falls smoothly to the rim, and to 0 for what faces away.
    const double facing = std::max(0.0, glm::dot(normal, support.normals[other]));
    const double weight = (1.0 - chord) * (1.0 - chord) * facing;
    // A circle through the vertex has the height k chord^2 / 2 whatever the chord, but not k flat^2 / 2: over
    // chords, spheres are quadrics, and the bias of a fit of finite size goes.
    const double stretch = flat > 0.0 ? std::sqrt(chord / flat) : 1.0;
    points.add(stretch * u, stretch * w, height, weight);
  }
  points.fill_lanes();
}

struct Fit {
  VertexBend bend;
  double deviation;  ///< of vertices off it, over lengths of the radius
};

/// Fits a quadric, or with terms up to the fourth power, to the vertices that a region holds within a radius.
/// None where there are too few, or where the surface is none over its tangent plane.
template <int degree>
std::optional<Fit> fit(const UnitMesh& mesh, const Support& support, const Region& region, double radius,
                       FitPoints& points) {
  const glm::dvec3& normal = support.normals[region.vertices().front()];
  if (normal == glm::dvec3(0.0)) return {};
  const TangentFrame frame(normal);
  take_points(mesh, support, region, frame, radius, points);
  const auto found = height_fit<degree>(points);
  if (!found) return {};
  const auto& c = found->coefficients;
  const Quadric quadric{c[0], c[1], c[2], c[3], c[4], c[5]};
  constexpr double steepest = 1.7;  // 60 degrees
  if (!(quadric.tilt_u * quadric.tilt_u + quadric.tilt_w * quadric.tilt_w < steepest * steepest)) return {};
  return Fit{bend_of(quadric, frame, normal, radius), found->deviation};
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Medians of some hundred vertices, over a ball's radius; 0 for small meshes.
struct Roughness {
  double noise = 0.0;  ///< standard deviation of vertices off the surface: what a quartic fit leaves
  double bend = 0.0;   ///< curvature of the quartic
};

Roughness roughness_of(const UnitMesh& mesh, const Support& support, double radius) {
  constexpr std::size_t samples = 256, least_samples = 32;
  std::vector<double> deviations, bends;
  FitPoints points;
  Region region(mesh);
  const std::size_t stride = std::max<std::size_t>(1, mesh.vertex_count() / samples);
  for (std::size_t vertex = 0; vertex < mesh.vertex_count(); vertex += stride) {
    const glm::dvec3& normal = support.normals[vertex];
    if (normal == glm::dvec3(0.0) || mesh.on_border[vertex] != 0) continue;
    region.grow_vertices(static_cast<std::uint32_t>(vertex), radius);
    take_points(mesh, support, region, TangentFrame(normal), radius, points);
    const auto found = height_fit<quartic_degree>(points);
    if (!found) continue;
    deviations.push_back(found->deviation);
    bends.push_back(std::max(std::abs(found->coefficients[3]), std::abs(found->coefficients[5])));
  }
  if (deviations.size() < least_samples) return {};
  return {median_of(deviations), median_of(bends)};
}

/// The ball of a fit, and whether it has terms up to the fourth power.
struct FitSize {
  double radius;
  bool is_quartic;
  double noise = 0.0;  ///< standard deviation of vertices off the surface, where it is quartic
};

constexpr double usual_edges = 3.5;

/// The error that noise makes of curvatures falls with the cube of the radius. The bias grows with its
/// square; terms up to the fourth power take most of it away. Both were measured: docs/meshes.md.
FitSize size_for(const UnitMesh& mesh, const Support& support) {
  constexpr double least_noise_edges = 0.004;  // of an edge: less is not worth a wider ball
  constexpr double wide_edges = 13.0;          // for noise of 0.02 edges
  constexpr double least_edges = 6.0, most_edges = 16.0;
  constexpr double most_bend = 1.2;  // radians within a ball: else the surface is no height over its plane
  const FitSize usual{usual_edges * mesh.mean_edge, false};
  const Roughness rough = roughness_of(mesh, support, usual.radius);
  const double noise_edges = usual_edges * rough.noise;
  if (noise_edges < least_noise_edges) return usual;
  const double wanted_edges = std::clamp(wide_edges * std::cbrt(noise_edges / 0.02), least_edges, most_edges);
  const double edges = std::min(wanted_edges, most_bend * usual_edges / rough.bend);
  if (edges < least_edges) return usual;
  return {edges * mesh.mean_edge, true, noise_edges * mesh.mean_edge};
}

/// Fits a quartic that leaves no more than noise: where the surface has smaller features than the ball, that
/// shrinks. Half of a ball at a border is empty, so that it has to be wider there.
std::optional<VertexBend> quartic_bend(const UnitMesh& mesh, const Support& support, std::uint32_t vertex,
                                       const FitSize& size, Region& region, FitPoints& points) {
  constexpr double border_edges = 24.0, least_edges = 5.0, shrinking = 0.8;
  constexpr double most_noise = 1.4;  // in a ball; a lower limit takes chance for features
  region.grow_vertices(vertex, size.radius);
  const bool has_border =
      std::ranges::any_of(region.vertices(), [&](std::uint32_t other) { return mesh.on_border[other] != 0; });
  double reach = has_border ? std::max(size.radius, border_edges * mesh.mean_edge) : size.radius;
  std::optional<Fit> found;
  for (; reach >= least_edges * mesh.mean_edge; reach *= shrinking) {
    if (reach != size.radius) region.grow_vertices(vertex, reach);
    const std::optional<Fit> closer = fit<quartic_degree>(mesh, support, region, reach, points);
    if (closer) found = closer;
    if (closer && closer->deviation * reach <= most_noise * size.noise) break;
  }
  if (!found) return {};
  return found->bend;
}

/// Fits to the vertices around one within a radius.
std::optional<VertexBend> bend_at(const UnitMesh& mesh, const Support& support, std::uint32_t vertex,
                                  const FitSize& size, Region& region, FitPoints& points) {
  if (size.is_quartic) {
    if (const auto bend = quartic_bend(mesh, support, vertex, size, region, points)) return bend;
  }
  region.grow_vertices(vertex, size.radius);
  const std::optional<Fit> found = fit<quadric_degree>(mesh, support, region, size.radius, points);
  if (!found) return {};
  return found->bend;
}

}  // namespace

// Where edges are longer than most, the ball is widened until it holds enough vertices; where nothing can be
// fitted, tensors answer. Without a given radius, the ball is wider on noisy meshes.
void fitted_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, std::optional<double> given_radius,
                  int threads, const BendSink& sink) {
  constexpr int most_tries = 3;
  const Support support = support_of(mesh, measures);
  const FitSize size = given_radius ? FitSize{*given_radius, false} : size_for(mesh, support);
  std::vector<std::uint8_t> is_open(mesh.vertex_count(), 0);
  parallel_chunks(mesh.vertex_count(), threads, [&](ChunkQueue& queue) {
    Region region(mesh);
    FitPoints points;
    queue.drain([&](std::size_t vertex) {
      std::optional<VertexBend> bend;
      double reach = size.radius;
      for (int i = 0; i < most_tries && !bend && measures.areas[vertex] > 0.0; ++i, reach *= 2.0) {
        bend = bend_at(mesh, support, static_cast<std::uint32_t>(vertex),
                       {reach, size.is_quartic, size.noise}, region, points);
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
