#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/terrain/field/post_grid.h"
#include "kernels/shared/terrain.h"

/// Rays over a height field: what they are, what they hit, and how many are cast at a time.
namespace offing::terrain {

/// A half-line of the world (y up, metres).
struct Ray {
  glm::dvec3 origin_m{0.0};
  glm::dvec3 direction{0.0, -1.0, 0.0};                      ///< of length 1 within 1e-4
  double limit_m = std::numeric_limits<double>::infinity();  ///< what is hit beyond is a miss
};

/// The farthest that a ray may start from a map: whole cells from there to a border are exact as floats.
inline constexpr double farthest_origin_cells = 1 << 22;

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
