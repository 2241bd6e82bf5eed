#pragma once

#include <cstddef>

#include "host/cli/terrain/terrain_input.h"
#include "host/command_line/setting_options.h"
#include "host/io/tile_store/tile_store.h"
#include "host/ocl/device.h"
#include "host/scene/model/terrain_scene.h"
#include "host/terrain/tiles/tiled_field.h"

/// Flags of commands that take a tile store, and the store as they ask for it.
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

/// Throws Error(bad_usage) for flags that the file, a height map or a tile store, does not take.
void require_flags_of(const TerrainInput& input, const CacheFlags& cache);

}  // namespace offing::cli
