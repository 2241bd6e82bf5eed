#pragma once

#include <vector>

#include "host/terrain/field/height_field.h"

namespace offing::terrain {

/// A node of the pyramid that a ray meets, or a cell, at level 0.
struct RayNode {
  int level = 0;
  int first_x = 0, first_z = 0;  ///< its first cell
  int side_cells = 1;
  float maximum_m = 0.0f;       ///< the highest post of its cells
  bool is_passed_over = false;  ///< the ray stays above the maximum: nothing within is looked at
};

/// The nodes and cells that a ray meets in front of a distance, in order: from the top of the pyramid down
/// wherever the ray dips below a maximum, as CastMethod::pdm walks, in double precision. Nodes are followed
/// by those within. For pictures that explain a ray: reads the pyramid back, and waits.
std::vector<RayNode> nodes_on_ray(const HeightField& field, const Ray& ray, double distance_m);

}  // namespace offing::terrain
