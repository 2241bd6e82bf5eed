#pragma once

#include <glm/vec2.hpp>

#include "host/base/height_map.h"

namespace offing::terrain {

/// Where the posts of a height field are: post [row][column] at x = origin_x_m + column spacing_x_m, z =
/// origin_z_m + row spacing_z_m.
struct PostGrid {
  int columns = 0, rows = 0;  ///< 2 ... 2^20 each, 2^30 posts at most
  double spacing_x_m = 1.0, spacing_z_m = 1.0;
  double origin_x_m = 0.0, origin_z_m = 0.0;
};

/// Throws Error(bad_input) that names what is out of range.
void require_valid(const PostGrid& grid);

/// The posts of a map, the first one at x = z = 0.
PostGrid post_grid(const HeightMap& map);

/// A place counted in posts from the first, of `posts` on its axis. The last post's place is a product, which
/// the quotient may miss by a rounding of each: a place that near to it is on it.
double place_in_posts(double from_first_m, double spacing_m, int posts);

/// Where a place is on a grid, in cells from its first post: (x, z).
glm::dvec2 cells_of(const PostGrid& grid, double x_m, double z_m);

/// How far a place lies beyond the map's edges, cells; 0 within.
double cells_beyond(const PostGrid& grid, double x_m, double z_m);

}  // namespace offing::terrain
