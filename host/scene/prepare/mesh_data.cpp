#include "host/scene/prepare/mesh_data.h"

#include <optional>
#include <utility>

#include "host/io/meshes/prepared_mesh.h"
#include "host/io/meshes/read_mesh.h"
#include "host/mesh_shapes/shape_table.h"
#include "host/scene/model/named_file.h"

namespace offing::scene {

namespace {

struct Surface {
  TriangleMesh mesh;
  std::optional<VertexCurvatures> curvatures;
};

Surface read_surface(const std::string& file, Trust trust) {
  if (!is_prepared(file)) return {read_mesh(file, trust), {}};
  PreparedMesh prepared = read_prepared(file);
  return {std::move(prepared.mesh), std::move(prepared.curvatures)};
}

void scale_by(double scale, Surface& surface) {
  for (glm::dvec3& position_m : surface.mesh.positions_m) position_m *= scale;
  if (!surface.curvatures) return;
  for (double& k_per_m : surface.curvatures->k_max_per_m) k_per_m /= scale;
  for (double& k_per_m : surface.curvatures->k_min_per_m) k_per_m /= scale;
  for (double& area_m2 : surface.curvatures->area_m2) area_m2 *= scale * scale;
}

}  // namespace

MeshData mesh_data(const Scene& scene, std::size_t index) {
  const MeshScene& mesh = scene.meshes.at(index);
  Surface surface;
  if (mesh.file.empty()) {
    mesh_shapes::Shape shape =
        mesh_shapes::made_shape(mesh_shapes::shapes().at(mesh.shape), mesh.size_m, mesh.detail);
    surface = {std::move(shape.mesh), std::move(shape.truth)};
  } else {
    surface = read_named(scene, {"mesh.file", {index, 0}}, "a mesh", mesh.file,
                         [&] { return read_surface(mesh.file, scene.trust); });
  }
  scale_by(mesh.scale, surface);
  MeshData data{.mesh = std::make_shared<const TriangleMesh>(std::move(surface.mesh)), .curvatures = {}};
  if (surface.curvatures) {
    data.curvatures = std::make_shared<const VertexCurvatures>(std::move(*surface.curvatures));
  }
  return data;
}

}  // namespace offing::scene
