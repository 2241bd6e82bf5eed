#pragma once

#include <list>

#include "host/base/height_map.h"
#include "host/base/height_tile.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/tiles/tile_cut.h"
#include "host/terrain/tiles/tile_loader.h"

namespace offing::terrain {

/// The posts of a map in tiles: those of level 0, read when they are asked for, of which the last 64 tiles
/// are kept, 34 MB. Coarser tiles stand in with their surface, which is nowhere below the map's. Not safe for
/// use from several threads at once.
class TilePosts {
 public:
  TilePosts(const TiledMap& map, TileReader read, Unreadable unreadable);

  /// Both throw what reading throws where no coarser tile stands in.
  float height_m(int column, int row);
  bool is_void(int column, int row);

 private:
  struct Kept {
    TileKey wanted;
    HeightTile tile;  ///< the wanted one, or what stands in for it
  };
  const HeightTile& tile_around(int column, int row);
  HeightTile read_or_stand_in(TileKey key) const;

  TiledMap map_;
  TileReader read_;
  Unreadable unreadable_;
  std::list<Kept> kept_;  ///< the last used first
};

/// The same as terrain_posts.h takes them.
TerrainPosts posts_of(const TiledMap& map, TileReader read, Unreadable unreadable);

/// The whole map as coarsely as its coarsest tiles have it, of mean heights, on its own extent. Throws what
/// reading throws.
HeightMap overview_of(const TiledMap& map, const TileReader& read);

}  // namespace offing::terrain
