// How a tile store is used: its flags, and the field that they make of it.
#include "host/cli/terrain/store_flags.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/prepare/stored_terrain.h"

namespace offing::cli {
namespace {

constexpr const char* store_group = "Tile stores";

}  // namespace

void CacheFlags::add_to(CLI::App& command) {
  SettingOptions::add_to(command, {{&StoreUse::cache_mb, like_scene("terrain.cache_mb", "--cache-mb")}},
                         store_group);
}

void CacheFlags::add_edge_to(CLI::App& command) {
  SettingOptions::add_to(command,
                         {{scene::choice(&StoreUse::edge, {"ends", "repeats", "mirrors"}),
                           {.key = "edge",
                            .help = "terrain beyond the map's edges: nothing (ends), the map again "
                                    "(repeats), or its mirror image (mirrors)"}}},
                         store_group);
}

terrain::TiledField make_field(const TileStore& store, const ocl::Device& device, const StoreUse& use) {
  return {device, scene::tiled_map(store.header(), use.edge), scene::tile_reader(store), use.cache_bytes()};
}

void require_flags_of(const TerrainInput& input, const CacheFlags& cache) {
  const bool is_store = is_tile_store(input.file());
  if (is_store && input.has_reading_flags()) {
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("{}: expected a height map for these flags on reading heights, found a tile store",
                    one_line(input.file())),
        "give them to `offing terrain tile` when you make the store");
  }
  if (!is_store && cache.are_given()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected a tile store for --cache-mb and --edge, found a height map",
                            one_line(input.file())),
                "leave them out, or make a store with `offing terrain tile`");
  }
}

}  // namespace offing::cli
