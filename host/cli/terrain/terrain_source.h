#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/base/height_map.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/command_line/setting_options.h"
#include "host/io/tile_store/tile_store.h"
#include "host/ocl/device.h"
#include "host/scene/model/terrain_scene.h"
#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/tiles/tiled_field.h"

namespace offing::cli {

/// How a tile store is used.
struct StoreUse {
  int cache_mb = scene::TerrainScene{}.cache_mb;  ///< for tiles, MiB
  terrain::MapEdge edge = terrain::MapEdge::ends;

  std::size_t cache_bytes() const { return static_cast<std::size_t>(cache_mb) << 20; }
};

/// Flags of commands that take a tile store. `this` must outlive the command.
class CacheFlags : public SettingOptions<StoreUse> {
 public:
  void add_to(CLI::App& command);
  /// That of pictures: what is beyond the map.
  void add_edge_to(CLI::App& command);
};

/// The store on a device, as much of it as the cache holds. Keeps a copy of the store.
terrain::TiledField make_field(const TileStore& store, const ocl::Device& device, const StoreUse& use);

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
  terrain::TerrainPosts posts_;
  std::optional<terrain::HeightField> field_;
  std::optional<terrain::TiledField> tiles_;
};

/// Throws Error(bad_usage) for flags that the file, a height map or a tile store, does not take.
void require_flags_of(const TerrainInput& input, const CacheFlags& cache);

}  // namespace offing::cli
