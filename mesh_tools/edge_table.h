#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/triangle_mesh.h"

namespace offing::mesh_tools {

/// One face at an edge.
struct EdgeUse {
  std::uint32_t low, high;  ///< its vertices, low < high
  std::uint32_t face;
  enum class Way : std::uint8_t { low_to_high, high_to_low } way;  ///< in which the face runs along it
};

/// Whether a face names a vertex twice.
bool repeats_vertex(const TriangleIndices& face);

/// The number of a face's corner at one of its vertices, among three for each face.
std::uint32_t corner_at(const std::vector<TriangleIndices>& faces, std::uint32_t face, std::uint32_t vertex);

/// The edges of all faces that name three vertices: for each edge all its uses, side by side.
class EdgeTable {
 public:
  explicit EdgeTable(const std::vector<TriangleIndices>& faces);

  /// Calls `visit` with the uses of each edge, one at least.
  template <typename Visit>
  void for_each_edge(Visit visit) const {
    for (std::size_t begin = 0, end = 0; begin < uses_.size(); begin = end) {
      while (end < uses_.size() && uses_[end].low == uses_[begin].low &&
             uses_[end].high == uses_[begin].high) {
        ++end;
      }
      visit(std::span(uses_).subspan(begin, end - begin));
    }
  }

 private:
  std::vector<EdgeUse> uses_;  // by vertices, then by face
};

}  // namespace offing::mesh_tools
