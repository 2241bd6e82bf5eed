#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// A layer of many clouds of one genus.
struct SkyCover {
  Genus genus = Genus::cumulus;
  double coverage = 0.3;              ///< share of the ground that lies below one, 0 ... 0.95
  glm::dvec2 middle_m{0.0};           ///< x, z in the world
  double extent_m = 20'000.0;         ///< side of the square
  std::optional<double> base_m = {};  ///< the middle of the genus' heights if left out
  double base_spread_m = 0.0;         ///< how far bases differ, up and down
  double size_spread = 0.4;           ///< sizes are 1 - this ... 1 + this of the preset's, 0 ... 0.9
  glm::dvec3 wind_mps{0.0};           ///< moves them all
  int most_clouds = 1000;             ///< Error(bad_input) where the cover needs more
};

/// Clouds of different seeds, sizes and turns at random places that cover about the share of the ground asked
/// for: by what discs of their balls cover, counted on a grid of 512 x 512, within 2 % where single clouds
/// are below that. The same cover and seed give the same sky; a larger coverage adds clouds to a smaller
/// one's. Throws Error(bad_input) for values out of range.
std::vector<CloudParameters> scattered_sky(const SkyCover& cover, std::uint64_t seed);

}  // namespace offing::clouds
