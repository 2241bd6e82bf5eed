#pragma once

#include <limits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/height_map.h"
#include "kernels/shared/terrain.h"

namespace offing::terrain {

/// A half-line of the world (y up, metres).
struct Ray {
  glm::dvec3 origin_m{0.0};
  glm::dvec3 direction{0.0, -1.0, 0.0};                      ///< of length 1 within 1e-4
  double limit_m = std::numeric_limits<double>::infinity();  ///< what is hit beyond is a miss
};

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

/// The farthest that a ray may start from a map: whole cells from there to a border are exact as floats.
inline constexpr double farthest_origin_cells = 1 << 22;

/// How far a place lies beyond the map's edges, cells; 0 within.
double cells_beyond(const PostGrid& grid, double x_m, double z_m);

/// Throws Error(bad_input) unless origin and direction are finite, the direction's length is 1 within 1e-4,
/// the origin is at most 2^22 cells from the map, and the limit is not below 0.
void require_valid(const Ray& ray, const PostGrid& grid);

/// A ray as kernels take it (shared/terrain.h).
TerrainRay device_ray(const Ray& ray, const PostGrid& grid);

}  // namespace offing::terrain
