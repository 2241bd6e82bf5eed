#include <array>

#include <glm/vec2.hpp>

#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {

Shape make_box(const glm::dvec3& sides_m, int cells) {
  require_shape_size("side", sides_m.x);
  require_shape_size("side", sides_m.y);
  require_shape_size("side", sides_m.z);
  require_grid({cells, cells}, 1);
  // Corners of a ring, from its starboard upper one under the bottom to port.
  constexpr std::array<glm::dvec2, 4> corners{{{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}}};  // y, z
  return {.mesh = lofted(
              {cells, 4 * cells},
              [&](int ring, int point) {
                const auto side = static_cast<std::size_t>(point / cells);
                const double along = static_cast<double>(point % cells) / cells;
                const glm::dvec2 place = corners[side] + along * (corners[(side + 1) % 4] - corners[side]);
                return sides_m * glm::dvec3(static_cast<double>(ring) / cells - 0.5, place.x, place.y);
              }),
          .truth = {}};
}

}  // namespace offing::mesh_shapes
