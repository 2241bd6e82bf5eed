#pragma once

#include <map>

#include "host/terrain/tiles/tiled_field.h"
#include "tests/terrain/example_maps.h"

namespace offing::test {

/// All tiles of a map, whose first post is put at x = z = 0.
class ExampleTiles {
 public:
  explicit ExampleTiles(HeightMap map);

  const HeightMap& map() const { return map_; }
  const TileSetShape& shape() const { return shape_; }
  const std::map<TileKey, HeightTile>& tiles() const { return tiles_; }
  terrain::TiledMap tiled_map(terrain::MapEdge edge = terrain::MapEdge::ends) const;
  /// Reads from this object, which must live as long.
  terrain::TileReader reader() const;

 private:
  HeightMap map_;
  TileSetShape shape_;
  std::map<TileKey, HeightTile> tiles_;
};

/// Rolling hills of 3 x 3 tiles at level 0 and 2 more levels, of which the last column and row are cut.
ExampleTiles hilly_tiles();

}  // namespace offing::test
