#pragma once

#include <cstddef>
#include <string>

#include <CLI/App.hpp>

#include "host/io/tile_store/tile_store.h"
#include "host/terrain/tiled_field.h"

namespace offing::cli {

/// Flags of commands that draw a tile store.
class CacheFlags {
 public:
  /// `this` must outlive the command.
  void add_to(CLI::App& command);

  /// --cache-mb; throws Error(bad_usage) for anything but 32 ... 65536.
  std::size_t bytes() const;
  terrain::MapEdge edge() const;

 private:
  std::string cache_mb_, edge_;
};

/// The map of a store, its first post at x = z = 0.
terrain::TiledMap tiled_map(const TileStoreHeader& header, terrain::MapEdge edge);

/// The store on a device, as much of it as the cache holds. Keeps a copy of the store.
terrain::TiledField make_field(const TileStore& store, const ocl::Device& device, const CacheFlags& flags);

}  // namespace offing::cli
