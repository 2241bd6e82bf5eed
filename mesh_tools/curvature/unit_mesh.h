#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/mesh_neighbours.h"
#include "host/base/triangle_mesh.h"

namespace offing::mesh_tools {

/// A mesh made ready for being measured: welded, moved and scaled into a cube of side 1 (so that squares of
/// lengths neither overflow nor vanish), with its neighbours. What vertex_curvatures() does not count as its
/// own time.
struct UnitMesh {
  std::vector<std::uint32_t> first;     ///< [vertices]: the vertex that stands for it, itself or one before
  MeshNeighbours neighbours;            ///< of the faces between those that stand for others
  std::vector<glm::dvec3> positions;    ///< [vertices] in units of scale_m
  std::vector<std::uint8_t> on_border;  ///< [vertices]: 1 for those with an edge of other than two faces
  double scale_m = 1.0;
  double mean_edge = 0.0;  ///< in units of scale_m; 0 without edges

  std::size_t vertex_count() const { return positions.size(); }
};

/// Throws Error(bad_input) as vertex_curvatures() does.
UnitMesh unit_mesh(const TriangleMesh& mesh);

/// Vertices - edges + faces of what has faces: 2 for a sphere, 0 for a torus, 1 for a disc.
long long euler_characteristic(const MeshNeighbours& mesh);

}  // namespace offing::mesh_tools
