#pragma once

#include <memory>

#include "host/base/triangle_mesh.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// The surface of a mesh of a scene, in its own axes; without curvatures they are found on the device.
struct MeshData {
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const VertexCurvatures> curvatures;
  Deformation deformation = {};
};

/// Reads or makes it. Throws Error(bad_input) that names the place in the scene for a file that is not there,
/// and what read_mesh() and read_prepared() throw.
MeshData mesh_data(const Scene& scene, std::size_t mesh);

}  // namespace offing::scene
