#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "mesh_tools/curvature/surface_measures.h"
#include "mesh_tools/curvature/unit_mesh.h"
#include "mesh_tools/curvature/vertex_bend.h"

namespace offing::mesh_tools {

/// The angles of the edges about each vertex and how much surface that is, averaged with its neighbours.
class DiffusedTensor {
 public:
  /// Keeps mesh and measures.
  DiffusedTensor(const UnitMesh& mesh, const SurfaceMeasures& measures, int rounds, int threads);

  VertexBend bend_at(std::size_t vertex) const;

 private:
  /// Six parts of the tensor, and the area; nothing, which fills a line of the cache. All are averaged alike.
  struct alignas(64) Share {
    std::array<double, 8> parts;

    Share& operator+=(const Share& other) {
      for (std::size_t i = 0; i < parts.size(); ++i) parts[i] += other.parts[i];
      return *this;
    }
    Share& operator*=(double factor) {
      for (double& part : parts) part *= factor;
      return *this;
    }
  };

  Share own_share(std::size_t vertex) const;
  Spread spread_about(std::size_t vertex, const VertexBend& bend) const;

  const UnitMesh& mesh_;
  const SurfaceMeasures& measures_;
  int rounds_;
  std::unique_ptr<Share[]> shares_;  // [vertices]
};

}  // namespace offing::mesh_tools
