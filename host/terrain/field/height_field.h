#pragma once

#include <memory>
#include <span>
#include <vector>

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/cast/ray.h"
#include "host/terrain/cast/relief_surface.h"
#include "host/terrain/field/post_grid.h"
#include "host/terrain/field/pyramid.h"

namespace offing::terrain {

/// How rays find their patches. All find the same; they differ in steps, iterations of a ray's walk.
enum class CastMethod {
  parity,  ///< starts at the lowest level whose maximum is above the eye; goes up with the parent. The
           ///< fastest; pictures on a CPU visit nodes once for 64 pixels
  paper,   ///< Park, Oh & Cho 2007: starts at the top; goes up a level after every miss (T4, T5)
  pdm,     ///< pyramidal displacement mapping: starts at the top; never goes up
  linear,  ///< from patch to patch, without the pyramid
};

/// Where the normals of hits come from.
enum class HitNormals {
  patch,   ///< the bilinear patch that is hit: exact, with creases between patches
  smooth,  ///< of posts the mean slopes between their neighbours, bilinear between posts: no creases
};

/// A map of heights on a device, the surface of bilinear patches between its posts, and what rays hit of it
/// (T1-T9 of docs/sources.md).
///
/// Ground is solid: a ray that comes in through the map's edge below the surface hits the side there, and one
/// that starts on or below the surface hits at 0 and is said to start inside. Otherwise the first hit is
/// found, never a later one. Borders between patches are watertight.
///
/// A hit's place, cell + (u, v), is within 1e-3 cells of a double-precision walk along the same ray up to
/// 2^16 cells away, across the surface (times |n.d|), and its distance within that and 2^-23 of itself, or of
/// the way within the map's box where the ray lies in host memory; where the ray touches the surface to less
/// than 1e-4 cells, hit and miss may differ. The directions of a camera's pixels are right to 3e-7.
/// (tests/terrain/ray_cast_test.cpp.)
///
/// cast() enqueues where it takes buffers. Every call may throw Error(out_of_memory) or Error(device). Not
/// safe for use from several threads at once.
class HeightField {
 public:
  /// heights_m [rows][columns], row-major, copied to the device; the pyramid is built there. Throws
  /// Error(bad_input) for a grid out of range, another number of heights, and heights that are not finite or
  /// beyond 1e6 m.
  HeightField(const ocl::Device& device, const PostGrid& grid, std::span<const float> heights_m);
  HeightField(HeightField&&) noexcept;
  HeightField& operator=(HeightField&&) noexcept;
  ~HeightField();

  const PostGrid& grid() const;
  const ocl::Buffer<float>& heights_m() const;
  const Pyramid& pyramid() const;
  float lowest_m() const;
  float highest_m() const;
  /// As kernels take it (shared/terrain.h).
  TerrainField device_field(CastMethod method) const;

  /// Enqueues the distances in metres along the camera's unit rays to what they hit first,
  /// [height_px][width_px], row 0 at the top; +inf is a miss. Throws what require_valid(camera) throws,
  /// Error(bad_input) for an eye that require_valid(Ray) refuses, and Error(bad_usage) if the buffer holds
  /// fewer.
  void cast(const Camera& camera, ocl::Buffer<float>& distances_m, CastMethod method = CastMethod::parity);
  /// The same with all of a TerrainHit.
  void cast(const Camera& camera, ocl::Buffer<TerrainHit>& hits, CastMethod method = CastMethod::parity,
            HitNormals normals = HitNormals::patch);
  /// The same of the ground as it is drawn, with the relief of this camera's eye; normals are those of the
  /// field's own patches.
  void cast(const Camera& camera, const ReliefSurface& relief, ocl::Buffer<TerrainHit>& hits);

  /// Enqueues what the first `count` rays hit first. Rays with numbers that are not finite miss. Throws
  /// Error(bad_usage) if a buffer holds fewer.
  void cast(const ocl::Buffer<TerrainRay>& rays, std::size_t count, ocl::Buffer<TerrainHit>& hits,
            CastMethod method = CastMethod::parity, HitNormals normals = HitNormals::patch);
  /// The same for rays in host memory; waits. Throws what require_valid(ray, grid) throws, before any is
  /// cast.
  std::vector<RayHit> cast(std::span<const Ray> rays, CastMethod method = CastMethod::parity,
                           HitNormals normals = HitNormals::patch);
  /// The same over ground that lies curve.bend_perm() d^2 lower at a distance d, in plan, from a ray's
  /// origin. Throws what require_valid(curve) throws too.
  std::vector<RayHit> cast(std::span<const Ray> rays, const EarthCurve& curve,
                           HitNormals normals = HitNormals::patch);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace offing::terrain
