#include "tests/terrain/example_tiles.h"

#include <algorithm>
#include <span>
#include <utility>

#include "host/terrain/tiles/tile_builder.h"

namespace offing::test {

ExampleTiles::ExampleTiles(HeightMap map)
    : map_(std::move(map)), shape_(TileSetShape::of(map_.grid.columns, map_.grid.rows)) {
  map_.grid.origin_x_m = map_.grid.origin_z_m = 0.0;
  terrain::TileBuilder builder(shape_, [this](HeightTile tile) {
    const TileKey key = tile.key;
    tiles_.emplace(key, std::move(tile));
  });
  const auto columns = static_cast<std::size_t>(map_.grid.columns);
  for (std::size_t row = 0; row < static_cast<std::size_t>(map_.grid.rows); ++row) {
    builder.add_row(std::span(map_.heights_m).subspan(row * columns, columns));
  }
}

terrain::TiledMap ExampleTiles::tiled_map(terrain::MapEdge edge) const {
  const auto [lowest, highest] = std::minmax_element(map_.heights_m.begin(), map_.heights_m.end());
  return {shape_, map_.grid.spacing_x_m, map_.grid.spacing_z_m, *lowest, *highest, edge};
}

terrain::TileReader ExampleTiles::reader() const {
  return [this](const TileKey& key) { return tiles_.at(key); };
}

ExampleTiles hilly_tiles() {
  return ExampleTiles(valleys({.columns = 701, .rows = 515, .spacing_x_m = 10.0, .spacing_z_m = 12.5}));
}

}  // namespace offing::test
