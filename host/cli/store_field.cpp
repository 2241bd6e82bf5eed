#include "host/cli/store_field.h"

#include <memory>

#include <CLI/Option.hpp>

#include "host/base/argument.h"

namespace offing::cli {

void CacheFlags::add_to(CLI::App& command) {
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    command.add_option(names, target, help)->type_name(placeholder)->group("Tile stores");
  };
  add("--cache-mb", cache_mb_, "MB", "memory for tiles, MiB (default 256)");
  add("--edge", edge_, "WHAT", "ends, repeats or mirrors: the map beyond its edges (default ends)");
}

std::size_t CacheFlags::bytes() const {
  constexpr std::size_t mebibyte = 1 << 20;
  return mebibyte * static_cast<std::size_t>(
                        cache_mb_.empty() ? 256 : read_whole("--cache-mb", cache_mb_, 32, 65536, "256"));
}

terrain::MapEdge CacheFlags::edge() const {
  if (edge_.empty() || edge_ == "ends") return terrain::MapEdge::ends;
  if (edge_ == "repeats") return terrain::MapEdge::repeats;
  if (edge_ == "mirrors") return terrain::MapEdge::mirrors;
  throw bad_argument("--edge", "ends, repeats or mirrors", edge_, "mirrors");
}

terrain::TiledMap tiled_map(const TileStoreHeader& header, terrain::MapEdge edge) {
  return {header.shape, header.spacing_x_m, header.spacing_z_m, header.lowest_m, header.highest_m, edge};
}

terrain::TiledField make_field(const TileStore& store, const ocl::Device& device, const CacheFlags& flags) {
  return {device, tiled_map(store.header(), flags.edge()),
          [store](const TileKey& key) { return store.read(key); }, flags.bytes()};
}

}  // namespace offing::cli
