#include "mesh_tools/edge_table.h"

#include <algorithm>
#include <tuple>

namespace offing::mesh_tools {

bool repeats_vertex(const TriangleIndices& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

std::uint32_t corner_at(const std::vector<TriangleIndices>& faces, std::uint32_t face, std::uint32_t vertex) {
  const TriangleIndices& corners = faces[face];
  return 3 * face + (corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2);
}

EdgeTable::EdgeTable(const std::vector<TriangleIndices>& faces) {
  uses_.reserve(3 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (repeats_vertex(faces[f])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = faces[f][i], to = faces[f][(i + 1) % 3];
      uses_.push_back({std::min(from, to), std::max(from, to), f,
                       from < to ? EdgeUse::Way::low_to_high : EdgeUse::Way::high_to_low});
    }
  }
  std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
}

}  // namespace offing::mesh_tools
