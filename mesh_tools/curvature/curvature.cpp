#include "mesh_tools/curvature/curvature.h"

#include <string_view>

#include <fmt/format.h>

#include "host/base/error.h"
#include "mesh_tools/curvature/bend_sink.h"

namespace offing::mesh_tools {
namespace {

void require_option(std::string_view name, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("curvature: {}: expected a value within {:g} ... {:g}, found {:g}", name, least,
                          most, value),
              fmt::format("choose {} within that range", name));
}

double radius_of(const UnitMesh& mesh, const CurvatureOptions& options) {
  if (!options.radius_m) {
    const double radius_edges = options.radius_edges.value_or(3.0);
    require_option("radius in edges", radius_edges, 0.01, 100.0);
    return radius_edges * mesh.mean_edge;
  }
  require_option("radius in metres", *options.radius_m, 1e-100, 1e100);
  return *options.radius_m / mesh.scale_m;
}

/// None where the fit chooses.
std::optional<double> fit_radius_of(const UnitMesh& mesh, const CurvatureOptions& options) {
  if (!options.radius_m && !options.radius_edges) return {};
  return radius_of(mesh, options);
}

void put_bends(const UnitMesh& mesh, const SurfaceMeasures& measures, const CurvatureOptions& options,
               const BendSink& sink) {
  switch (options.method) {
    case CurvatureMethod::fit:
      return fitted_bends(mesh, measures, fit_radius_of(mesh, options), options.threads, sink);
    case CurvatureMethod::tensor:
      return ball_tensor_bends(mesh, measures, radius_of(mesh, options), options.threads, sink);
    case CurvatureMethod::tensor_exact:
      return clipped_tensor_bends(mesh, measures, radius_of(mesh, options), options.threads, sink);
    case CurvatureMethod::paper:
      return printed_tensor_bends(mesh, measures, radius_of(mesh, options), options.angles, options.threads,
                                  sink);
    case CurvatureMethod::diffused:
      require_option("rounds", options.rounds, 0, 1000);
      return diffused_tensor_bends(mesh, measures, options.rounds, options.threads, sink);
    case CurvatureMethod::jet:
      return jet_bends(mesh, measures, options.threads, sink);
  }
  throw Error(ErrorKind::bad_usage, "curvature: unknown method", "use one of CurvatureMethod");
}

}  // namespace

CurvatureResult vertex_curvatures(const UnitMesh& mesh, const CurvatureOptions& options) {
  require_option("threads", options.threads, 0, 1 << 16);
  const SurfaceMeasures measures = measure_surface(mesh, options.threads);
  CurvatureResult result;
  const BendSink sink(mesh, measures, result);
  put_bends(mesh, measures, options, sink);
  sink.finish(options.threads);
  return result;
}

CurvatureResult vertex_curvatures(const TriangleMesh& mesh, const CurvatureOptions& options) {
  return vertex_curvatures(unit_mesh(mesh), options);
}

}  // namespace offing::mesh_tools
