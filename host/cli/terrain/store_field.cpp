#include "host/cli/terrain/store_field.h"

#include <memory>

#include <CLI/Option.hpp>

#include "host/base/argument.h"
#include "host/scene/prepare/stored_terrain.h"

namespace offing::cli {

namespace {

void add(CLI::App& command, const char* names, std::string& target, const char* placeholder,
         const char* help) {
  command.add_option(names, target, help)->type_name(placeholder)->group("Tile stores");
}

}  // namespace

void CacheFlags::add_to(CLI::App& command) {
  add(command, "--cache-mb", cache_mb_, "MB", "memory for tiles, MiB (default 256)");
}

void CacheFlags::add_edge_to(CLI::App& command) {
  add(command, "--edge", edge_, "WHAT", "ends, repeats or mirrors: the map beyond its edges (default ends)");
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

terrain::TiledField make_field(const TileStore& store, const ocl::Device& device, const CacheFlags& flags) {
  return {device, scene::tiled_map(store.header(), flags.edge()), scene::tile_reader(store), flags.bytes()};
}

}  // namespace offing::cli
