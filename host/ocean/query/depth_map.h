#pragma once

#include <vector>

namespace offing::ocean {

/// How deep still water stands over a bed, at the posts of a grid and bilinear between them. Beyond the
/// grid's edge the bed goes on as it is there, and sinks by SHOAL_STEEPEST (kernels/shared/shoal_params.h).
struct DepthMap {
  int columns = 0, rows = 0;                    ///< at least 2
  double origin_x_m = 0.0, origin_z_m = 0.0;    ///< of the first post, in the world
  double spacing_x_m = 1.0, spacing_z_m = 1.0;  ///< between neighbouring posts, above 0
  std::vector<float> depths_m;                  ///< [rows][columns], row-major, negative above the water

  /// At a place of the world, in double precision: what ocean/surface_query.cl reads.
  double depth_m(double x_m, double z_m) const;
  /// The least depth of all posts.
  float shallowest_m() const;
};

/// Raises the bed until it is nowhere steeper than SHOAL_STEEPEST: each depth becomes the least, over all
/// posts, of theirs and as much more as the way to them allows, along rows, columns and diagonals (Rosenfeld
/// & Pfaltz 1966, distances in two passes).
void limit_slopes(DepthMap& map);

/// Throws Error(bad_input) for a map of less than 2 x 2 or more than 2^28 posts, of another number of depths,
/// without extent, or not finite.
void require_valid_depths(const DepthMap& map);

}  // namespace offing::ocean
