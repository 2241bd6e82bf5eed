// The wetted surface of a hull in still water as flat panels, for the panel method.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::bodies {

/// A flat triangle or quadrangle.
struct Panel {
  std::array<glm::dvec3, 4> corners_m;  ///< counter-clockwise seen against the normal
  std::size_t corner_count = 3;
  glm::dvec3 centre_m{0.0};
  glm::dvec3 normal{0.0};  ///< into the water
  double area_m2 = 0.0;
};

/// Panels in axes whose origin is on the still water, and on the planes of symmetry if there are any.
struct PanelHull {
  /// Those of the hull, then those of the cover: of the half z > 0, or the quarter x < 0, z > 0, of a
  /// symmetric hull.
  std::vector<Panel> panels;
  std::size_t wetted_count = 0;  ///< panels of the hull
  /// What places are multiplied by: 1, then -1 along z, then -1 along x without and with -1 along z. As many
  /// as the hull has such parts: 1, 2 or 4.
  std::vector<glm::dvec3> images;
  glm::dvec3 origin_m{0.0};  ///< in the axes of the mesh
  double length_m = 0.0;     ///< geometric mean of the wetted part's length and breadth
};

/// About this many panels of the part of a closed mesh below y = level_m; with their images, sqrt(2) or 2
/// times as many of hulls with 1 or 2 planes of symmetry, which take the same time to solve: triangles of
/// even size and shape (even_mesh()), stretched to the same volume and water plane. A cover a little below
/// the inner water plane, a sixth more panels, keeps the water inside from resonating. Throws
/// Error(bad_input) if nothing is below the level.
PanelHull panel_hull(const TriangleMesh& mesh, double level_m, std::size_t panels);

}  // namespace offing::bodies
