#pragma once

#include <cstddef>
#include <string>

#include <CLI/App.hpp>

#include "host/io/tile_store/tile_store.h"
#include "host/terrain/tiles/tiled_field.h"

namespace offing::cli {

/// Flags of commands that take a tile store. `this` must outlive the command.
class CacheFlags {
 public:
  void add_to(CLI::App& command);
  /// That of pictures: what is beyond the map.
  void add_edge_to(CLI::App& command);

  /// --cache-mb; throws Error(bad_usage) for anything but 32 ... 65536.
  std::size_t bytes() const;
  terrain::MapEdge edge() const;
  bool are_given() const { return !cache_mb_.empty() || !edge_.empty(); }

 private:
  std::string cache_mb_, edge_;
};

/// The store on a device, as much of it as the cache holds. Keeps a copy of the store.
terrain::TiledField make_field(const TileStore& store, const ocl::Device& device, const CacheFlags& flags);

}  // namespace offing::cli
