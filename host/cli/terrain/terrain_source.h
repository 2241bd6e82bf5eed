#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/base/height_map.h"
#include "host/cli/terrain/store_flags.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/io/height_maps/map_coordinates.h"
#include "host/io/tile_store/tile_store.h"
#include "host/ocl/device.h"
#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/tiles/tiled_field.h"

namespace offing::cli {

/// The ground that questions are about: a height map in memory, or a tile store, whose answers are those of
/// the map that it was made of. Its first post is at x = z = 0.
class TerrainSource {
 public:
  /// Throws what reading throws, and Error(bad_usage) for flags that this kind of file does not take.
  TerrainSource(const TerrainInput& input, const CacheFlags& cache);
  TerrainSource(const TerrainSource&) = delete;
  TerrainSource& operator=(const TerrainSource&) = delete;

  /// Throw Error(bad_input) for a tile that cannot be read.
  const terrain::TerrainPosts& posts() const { return posts_; }
  terrain::PostGrid grid() const;
  /// Where it lies in the world.
  const MapFrame& frame() const { return frame_; }

  /// From now on rays are cast there.
  void open(const ocl::Device& device);
  /// What rays hit over ground that falls away by a curve, or none. Throws Error(bad_usage) before open(),
  /// and what HeightField::cast() and TiledField::cast_fully() throw.
  std::vector<terrain::RayHit> cast(std::span<const terrain::Ray> rays, const terrain::EarthCurve& curve,
                                    terrain::HitNormals normals = terrain::HitNormals::patch);

 private:
  StoreUse use_;
  std::optional<HeightMap> map_;    // either this
  std::optional<TileStore> store_;  // or this
  MapFrame frame_;
  terrain::TerrainPosts posts_;
  std::optional<terrain::HeightField> field_;
  std::optional<terrain::TiledField> tiles_;
};

}  // namespace offing::cli
