#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/height_map.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
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

/// A place counted in posts from the first, of `posts` on its axis. The last post's place is a product, which
/// the quotient may miss by a rounding of each: a place that near to it is on it.
double place_in_posts(double from_first_m, double spacing_m, int posts);

/// The farthest that a ray may start from a map: whole cells from there to a border are exact as floats.
inline constexpr double farthest_origin_cells = 1 << 22;

/// How far a place lies beyond the map's edges, cells; 0 within.
double cells_beyond(const PostGrid& grid, double x_m, double z_m);

/// Throws Error(bad_input) unless origin and direction are finite, the direction's length is 1 within 1e-4,
/// the origin is at most 2^22 cells from the map, and the limit is not below 0.
void require_valid(const Ray& ray, const PostGrid& grid);

/// A ray as kernels take it (shared/terrain.h).
TerrainRay device_ray(const Ray& ray, const PostGrid& grid);

/// A ray that begins a cell before the box of a map, or where it began if that is nearer, over ground that
/// falls away by `bend_perm` times the square of the distance in plan. Devices have floats, which lose the
/// digits of long ways. Its direction is no unit vector where the ground falls away.
struct RayToBox {
  Ray ray;
  double moved_m = 0.0;  ///< from its old origin to its new one
};
RayToBox moved_to_box(const Ray& ray, const PostGrid& grid, double highest_m, double bend_perm = 0.0);

/// What a ray hit first. As a TerrainHit, but for the distance, which is from the ray's own origin: right to
/// 2^-23 of the ray's way in the map's box, and to 1e-3 cells across the surface.
struct RayHit {
  double distance_m = std::numeric_limits<double>::infinity();
  double resolution_m = 0.0;  ///< the step of the floats behind the distance: digits below are noise
  int kind = TERRAIN_MISS;
  int cell_x = 0, cell_z = 0;
  float u = 0.0f, v = 0.0f;
  float normal_x = 0.0f, normal_y = 0.0f, normal_z = 0.0f;
  int steps = 0;

  /// A length along the ray, or a coordinate of a place on it, with the decimals that the distance has: to
  /// the smallest power of ten that is not below its resolution.
  double rounded_m(double length_m) const;
  glm::dvec3 rounded_m(const glm::dvec3& point_m) const;
};
RayHit ray_hit(const TerrainHit& hit, double moved_m);

/// Casts rays that lie in host memory, as many at a time as its buffers hold. Not safe for use from several
/// threads at once.
class HostRays {
 public:
  using Cast = std::function<void(const ocl::Buffer<TerrainRay>& rays, std::size_t count,
                                  ocl::Buffer<TerrainHit>& hits)>;

  /// What the rays hit; waits. `cast` enqueues what the first `count` rays hit. Throws what `cast` throws,
  /// and Error(out_of_memory) and Error(device).
  std::vector<RayHit> cast(const ocl::Device& device, const PostGrid& grid, std::span<const RayToBox> rays,
                           const Cast& cast);

 private:
  ocl::Buffer<TerrainRay> rays_;
  ocl::Buffer<TerrainHit> hits_;
};

}  // namespace offing::terrain
