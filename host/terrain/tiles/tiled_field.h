#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/program.h"
#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/cast/ray.h"
#include "host/terrain/cast/relief_surface.h"
#include "host/terrain/field/post_grid.h"
#include "host/terrain/tiles/tile_cut.h"
#include "host/terrain/tiles/tile_loader.h"

namespace offing::terrain {

/// How kernels are built that walk tiles.
ocl::Defines tiles_defines(int lanes, MapEdge edge);

/// A map of any size, of which a device holds as many tiles as a budget allows: near the eye the map's own
/// posts, farther away coarser ones, so that a cell is about a pixel wide (T12 of docs/sources.md).
///
/// What rays hit is the surface of the tiles that lie there. It is that of a HeightField where they are of
/// level 0. Coarser tiles are nowhere below the map's surface, so that a ray that hits the map always hits
/// them; a tile that is not there yet, or cannot be read, is stood in for by a coarser one. Ground is solid
/// where tiles of two levels meet. Where the map repeats or mirrors, rays go through up to 64 copies of it;
/// hits name the cells of the map, and shadows end at its edges.
///
/// Not safe for use from several threads at once; tiles are read by a thread of its own.
class TiledField {
 public:
  /// How the tiles of the last look() stand.
  struct Statistics {
    std::size_t tiles = 0;     ///< of the cut
    std::size_t stood_in = 0;  ///< of these, those for which coarser ones stand in
    std::uint64_t loaded = 0;  ///< since the beginning
    std::uint64_t failed = 0;  ///< that could not be read; a warning named each
    std::size_t slots = 0, bytes = 0;
  };

  /// Reads the coarsest level. Throws what TileCache throws.
  TiledField(const ocl::Device& device, const TiledMap& map, TileReader read, std::size_t cache_bytes);
  TiledField(TiledField&&) noexcept;
  TiledField& operator=(TiledField&&) noexcept;
  ~TiledField();

  const TiledMap& map() const;
  /// Places of the map's posts.
  const PostGrid& grid() const;

  /// Chooses tiles for a camera, takes in those that have been loaded and asks for the others, and then for
  /// those that the camera will want `ahead_m` further along the way that it came since the last look. Does
  /// not wait. Throws what require_valid(camera) throws.
  void look(const Camera& camera, double ahead_m = 0.0);
  /// The same, and waits until no tile that can be read is missing.
  void look_and_wait(const Camera& camera);
  const Statistics& statistics() const;

  /// Enqueues what the camera's rays hit first, as HeightField::cast() does, of the tiles of the last look.
  /// Throws Error(bad_usage) before the first one.
  void cast(const Camera& camera, ocl::Buffer<float>& distances_m);
  void cast(const Camera& camera, ocl::Buffer<TerrainHit>& hits);
  /// The same of the ground as it is drawn, with the relief of this camera's eye.
  void cast(const Camera& camera, const ReliefSurface& relief, ocl::Buffer<TerrainHit>& hits);
  /// The same for rays in host memory; waits.
  std::vector<RayHit> cast(std::span<const Ray> rays);

  /// What the rays hit first of the map itself, whatever tiles the last look() chose: those of level 0 are
  /// loaded wherever a ray does not pass above coarser ones, and waited for. `curve` as HeightField::cast()
  /// takes it. Needs no look(), and another one is due before the next picture. Throws Error(bad_usage) for a
  /// map that repeats or mirrors, Error(bad_input) for a tile that cannot be read, and where a single ray
  /// needs more tiles than there are slots.
  std::vector<RayHit> cast_fully(std::span<const Ray> rays, const EarthCurve& curve = {});

  /// Highest post of the coarsest level around a place of the plan, which is held to the map: nothing there
  /// is higher.
  float coarse_height_m(double x_m, double z_m) const;

  /// A camera as kernels take it; its eye is brought to the map where that repeats or mirrors.
  TerrainView device_view(const Camera& camera) const;
  /// As kernels take it with TILED.
  TerrainField device_field() const;
  const ocl::Buffer<float>& pool() const;
  /// Throws Error(bad_usage) before the first look.
  const ocl::Buffer<float>& pages() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace offing::terrain
