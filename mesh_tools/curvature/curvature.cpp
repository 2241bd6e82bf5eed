#include "mesh_tools/curvature/curvature.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parallel_chunks.h"
#include "mesh_tools/curvature/methods.h"

namespace offing::mesh_tools {
namespace {

constexpr std::array<std::pair<std::string_view, CurvatureMethod>, 6> methods{{
    {"fit", CurvatureMethod::fit},
    {"tensor", CurvatureMethod::tensor},
    {"tensor-exact", CurvatureMethod::tensor_exact},
    {"paper", CurvatureMethod::paper},
    {"diffused", CurvatureMethod::diffused},
    {"jet", CurvatureMethod::jet},
}};

void require_option(std::string_view name, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("curvature: {}: expected a value within {:g} ... {:g}, found {:g}", name, least,
                          most, value),
              fmt::format("choose {} within that range", name));
}

double radius_of(const UnitMesh& mesh, const CurvatureOptions& options) {
  if (!options.radius_m) {
    // A fit's weights fall toward the rim: it takes a wider ball to hold as much.
    const double radius_edges =
        options.radius_edges.value_or(options.method == CurvatureMethod::fit ? 3.5 : 3.0);
    require_option("radius in edges", radius_edges, 0.01, 100.0);
    return radius_edges * mesh.mean_edge;
  }
  require_option("radius in metres", *options.radius_m, 1e-100, 1e100);
  return *options.radius_m / mesh.scale_m;
}

std::vector<VertexBend> bends_of(const UnitMesh& mesh, const SurfaceMeasures& measures,
                                 const CurvatureOptions& options) {
  switch (options.method) {
    case CurvatureMethod::fit:
      return fitted_bends(mesh, measures, radius_of(mesh, options), options.threads);
    case CurvatureMethod::tensor:
      return ball_tensor_bends(mesh, measures, radius_of(mesh, options), options.threads);
    case CurvatureMethod::tensor_exact:
      return clipped_tensor_bends(mesh, measures, radius_of(mesh, options), options.threads);
    case CurvatureMethod::paper:
      return printed_tensor_bends(mesh, measures, radius_of(mesh, options), options.angles, options.threads);
    case CurvatureMethod::diffused:
      require_option("rounds", options.rounds, 0, 1000);
      return diffused_tensor_bends(mesh, measures, options.rounds, options.threads);
    case CurvatureMethod::jet:
      return jet_bends(mesh, measures, options.threads);
  }
  throw Error(ErrorKind::bad_usage, "curvature: unknown method", "use one of CurvatureMethod");
}

/// How much one direction is preferred: 0 where all bend alike, 1 where one does not bend at all or bends the
/// other way.
double confidence_of(const UnitMesh& mesh, std::uint32_t vertex, const VertexBend& bend) {
  // Over an edge, less than this angle is rounding: a plane has no direction.
  constexpr double flat_rad = 1e-9;
  constexpr double border_share = 0.5;
  const double sum = std::abs(bend.k_max) + std::abs(bend.k_min) + flat_rad / mesh.mean_edge;
  return (bend.k_max - bend.k_min) / sum * (mesh.on_border[vertex] != 0 ? border_share : 1.0);
}

bool is_sound(const VertexBend& bend) {
  const double sum =
      bend.k_max + bend.k_min + glm::dot(bend.e_max, bend.e_max) + glm::dot(bend.normal, bend.normal);
  return std::isfinite(sum) && bend.normal != glm::dvec3(0.0);
}

void store(const UnitMesh& mesh, const SurfaceMeasures& measures, const std::vector<VertexBend>& bends,
           std::uint32_t vertex, CurvatureResult& result) {
  const std::uint32_t source = mesh.first[vertex];
  VertexCurvatures& curvatures = result.curvatures;
  curvatures.area_m2[vertex] = measures.areas[source] * mesh.scale_m * mesh.scale_m;
  const VertexBend& bend = bends[source];
  if (!is_sound(bend)) {
    if (measures.normals[source] != glm::dvec3(0.0)) result.normals[vertex] = measures.normals[source];
    return;
  }
  curvatures.k_max_per_m[vertex] = bend.k_max / mesh.scale_m;
  curvatures.k_min_per_m[vertex] = bend.k_min / mesh.scale_m;
  curvatures.e_max[vertex] = bend.e_max;
  curvatures.e_min[vertex] = bend.e_min;
  curvatures.confidence[vertex] = confidence_of(mesh, source, bend);
  result.normals[vertex] = bend.normal;
}

}  // namespace

CurvatureResult vertex_curvatures(const UnitMesh& mesh, const CurvatureOptions& options) {
  require_option("threads", options.threads, 0, 1 << 16);
  const SurfaceMeasures measures = measure_surface(mesh, options.threads);
  const std::vector<VertexBend> bends = bends_of(mesh, measures, options);
  CurvatureResult result;
  const std::size_t vertices = mesh.vertex_count();
  for (std::vector<double>* values : {&result.curvatures.k_max_per_m, &result.curvatures.k_min_per_m,
                                      &result.curvatures.area_m2, &result.curvatures.confidence}) {
    values->assign(vertices, 0.0);
  }
  result.curvatures.e_max.assign(vertices, {});
  result.curvatures.e_min.assign(vertices, {});
  result.normals.assign(vertices, {0.0, 0.0, 1.0});
  parallel_for(vertices, options.threads, [&](std::size_t vertex) {
    store(mesh, measures, bends, static_cast<std::uint32_t>(vertex), result);
  });
  return result;
}

CurvatureResult vertex_curvatures(const TriangleMesh& mesh, const CurvatureOptions& options) {
  return vertex_curvatures(unit_mesh(mesh), options);
}

CurvatureMethod curvature_method(std::string_view name) {
  for (const auto& [known, method] : methods) {
    if (known == name) return method;
  }
  throw Error(
      ErrorKind::bad_usage,
      fmt::format("--method: expected fit, tensor, tensor-exact, paper, diffused or jet, got \"{}\"", name),
      "leave it out for the default");
}

std::string_view name_of(CurvatureMethod method) {
  for (const auto& [name, known] : methods) {
    if (known == method) return name;
  }
  return "unknown";
}

}  // namespace offing::mesh_tools
