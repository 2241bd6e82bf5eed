// Makes the result of what methods put.
#include "mesh_tools/curvature/bend_sink.h"

#include "host/base/parallel_for.h"

namespace offing::mesh_tools {

BendSink::BendSink(const UnitMesh& mesh, const SurfaceMeasures& measures, CurvatureResult& result)
    : mesh_(mesh), measures_(measures), result_(result) {
  constexpr double flat_rad = 1e-9;
  flat_bend_ = flat_rad / mesh.mean_edge;
  const std::size_t vertices = mesh.vertex_count();
  VertexCurvatures& curvatures = result.curvatures;
  for (std::vector<double>* values :
       {&curvatures.k_max_per_m, &curvatures.k_min_per_m, &curvatures.area_m2, &curvatures.confidence}) {
    values->assign(vertices, 0.0);
  }
  curvatures.e_max.assign(vertices, {});
  curvatures.e_min.assign(vertices, {});
  result.normals.assign(vertices, {0.0, 0.0, 1.0});
}

void BendSink::finish(int threads) const {
  VertexCurvatures& curvatures = result_.curvatures;
  parallel_for(mesh_.vertex_count(), threads, [&](std::size_t vertex) {
    const std::uint32_t source = mesh_.first[vertex];
    if (source == vertex) return;
    for (std::vector<double>* values :
         {&curvatures.k_max_per_m, &curvatures.k_min_per_m, &curvatures.area_m2, &curvatures.confidence}) {
      (*values)[vertex] = (*values)[source];
    }
    curvatures.e_max[vertex] = curvatures.e_max[source];
    curvatures.e_min[vertex] = curvatures.e_min[source];
    result_.normals[vertex] = result_.normals[source];
  });
}

}  // namespace offing::mesh_tools
