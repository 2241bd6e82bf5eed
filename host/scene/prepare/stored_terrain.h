#pragma once

#include "host/base/height_map.h"
#include "host/io/tile_store/tile_store.h"
#include "host/terrain/tiles/tile_cut.h"
#include "host/terrain/tiles/tile_loader.h"

namespace offing::scene {

/// The map of a tile store as rays take it, its first post at x = z = 0.
terrain::TiledMap tiled_map(const TileStoreHeader& header, terrain::MapEdge edge = terrain::MapEdge::ends);

/// Reads a store's tiles; keeps a copy of the store.
terrain::TileReader tile_reader(const TileStore& store);

/// Where a store's posts are, without their heights: what read_colour_map() asks for.
HeightMap place_of(const TileStoreHeader& header);

/// Posts of a map, from the first column and row on.
struct PostWindow {
  int first_column = 0, first_row = 0;
  int columns = 0, rows = 0;
};

/// Those posts of a store that are within a radius of a place, in plan, and at least 2 x 2 of them.
PostWindow window_around(const TileStoreHeader& header, double x_m, double z_m, double radius_m);

/// The posts of a window as a map of its own, with its voids and its place. Throws what reading tiles throws.
HeightMap read_window(const TileStore& store, const PostWindow& window);

}  // namespace offing::scene
