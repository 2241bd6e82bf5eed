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

/// Panels in axes whose origin is on the still water, and on the plane of symmetry if there is one.
struct PanelHull {
  std::vector<Panel> panels;  ///< those of the hull, then those of the cover; one half of them if is_mirrored
  std::size_t wetted_count = 0;  ///< panels of the hull
  bool is_mirrored = false;      ///< whether the rest are the images in z = 0
  glm::dvec3 origin_m{0.0};      ///< in the axes of the mesh
  double length_m = 0.0;         ///< geometric mean of the wetted part's length and breadth
};

/// About `most_panels` panels, both halves together, of the part of a closed mesh below y = level_m: a
/// coarser mesh of the same volume if it has more faces, halved along its longest edges if it has fewer. A
/// cover a little below the inner water plane, a sixth more panels, keeps the water inside from resonating.
/// Throws Error(bad_input) if nothing is below the level.
PanelHull panel_hull(const TriangleMesh& mesh, double level_m, std::size_t most_panels);

}  // namespace offing::bodies
