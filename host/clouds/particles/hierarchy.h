#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/work.h"
#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// A particle of a hierarchy (C7).
struct HierarchyParticle {
  glm::dvec3 centre_m{0.0};
  double radius_m = 0.0;     ///< drawn
  double repulsion_m = 0.0;  ///< keeps other children of its level away; 0 of a seed
  int level = 0;             ///< 0 of a seed
  int parent = -1;           ///< its number, -1 of a seed
};

/// Seeds, then their children on their spheres, then the children of these, level by level (C7). A child's
/// centre lies on the sphere of its parent, and the centres of two children of a level, of whatever parents,
/// are as far apart as their repulsion radii together, at least. A first child is put at a random place;
/// neighbours grow around it, each touching it and the one before, then around these. Where they touch
/// follows from the spherical triangle of the three, not from the flat one of the print, whose children are
/// too close. What gaps remain are filled: in the end no sphere has room for another child of the smallest
/// radius of its level, ratio times the parent's.
///
/// The same seed gives the same particles. Throws Error(bad_input) for more than 10^7, where it can be told
/// before a level is grown, and Error(cancelled).
std::vector<HierarchyParticle> grown_hierarchy(std::span<const Metaball> seeds,
                                               std::span<const HierarchyLevel> levels, std::uint64_t seed,
                                               const Work& work = {});

}  // namespace offing::clouds
