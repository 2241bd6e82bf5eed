#include "host/scene/mesh_data.h"

#include <optional>
#include <utility>

#include "host/io/meshes/prepared_mesh.h"
#include "host/io/meshes/read_mesh.h"
#include "host/scene/named_file.h"

namespace offing::scene {

namespace {

using mesh_shapes::Shape;

struct Surface {
  TriangleMesh mesh;
  std::optional<VertexCurvatures> curvatures;
};

/// A grid that has these cells at detail 2.
mesh_shapes::Grid grid_of(int u_cells, int v_cells, int detail) {
  return {(u_cells << detail) / 4, (v_cells << detail) / 4};
}

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

Shape made_shape(MeshShape shape, double size_m, int detail) {
  switch (shape) {
    case MeshShape::knot: {
      const mesh_shapes::TorusKnot unit;
      return mesh_shapes::make_torus_knot({.radius_m = unit.radius_m * size_m,
                                           .winding_m = unit.winding_m * size_m,
                                           .tube_radius_m = unit.tube_radius_m * size_m},
                                          grid_of(120, 12, detail));
    }
    case MeshShape::sphere:
      return mesh_shapes::make_sphere(size_m, detail + 2);
    case MeshShape::ellipsoid:
      return mesh_shapes::make_ellipsoid(size_m * glm::dvec3(1.0, 0.75, 0.5), detail + 2);
    case MeshShape::torus:
      return mesh_shapes::make_torus(size_m, 0.4 * size_m, grid_of(80, 32, detail));
    case MeshShape::saddle:
      return mesh_shapes::make_saddle(size_m, grid_of(48, 48, detail));
    case MeshShape::head:
      return mesh_shapes::make_head(size_m, detail + 3);
    case MeshShape::ship:
      return mesh_shapes::make_ship(size_m, grid_of(120, 64, detail));
    case MeshShape::bird:
      return mesh_shapes::make_bird(size_m, grid_of(120, 24, detail));
    case MeshShape::boat:
      return mesh_shapes::make_boat(size_m, grid_of(96, 64, detail));
    case MeshShape::box:
      return mesh_shapes::make_box(glm::dvec3(2.0 * size_m), 1 << detail);
  }
  return {};
}

MeshData mesh_data(const OceanScene& scene, std::size_t index) {
  const MeshScene& mesh = scene.meshes.at(index);
  Surface surface;
  if (mesh.file.empty()) {
    Shape shape = made_shape(mesh.shape, mesh.size_m, mesh.detail);
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
