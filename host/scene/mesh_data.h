#pragma once

#include <memory>

#include "host/base/triangle_mesh.h"
#include "host/mesh_shapes/shape.h"
#include "host/scene/ocean_scene.h"

namespace offing::scene {

/// The surface of a mesh of a scene, in its own axes; without curvatures they are found on the device.
struct MeshData {
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const VertexCurvatures> curvatures;
};

/// A shape made by a formula, as fine as `mesh.detail` says. size_m: radius, of ship and
/// boat length, of bird span, of a box half its side.
mesh_shapes::Shape made_shape(MeshShape shape, double size_m, int detail);

/// Reads or makes it. Throws Error(bad_input) that names the place in the scene for a file that is not there,
/// and what read_mesh() and read_prepared() throw.
MeshData mesh_data(const OceanScene& scene, std::size_t mesh);

}  // namespace offing::scene
