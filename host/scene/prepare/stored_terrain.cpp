#include "host/scene/prepare/stored_terrain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace offing::scene {

terrain::TiledMap tiled_map(const TileStoreHeader& header, terrain::MapEdge edge) {
  return {header.shape, header.spacing_x_m, header.spacing_z_m, header.lowest_m, header.highest_m, edge};
}

terrain::TileReader tile_reader(const TileStore& store) {
  return [store](const TileKey& key) { return store.read(key); };
}

HeightMap place_of(const TileStoreHeader& header) {
  HeightMap place;
  place.columns = header.shape.columns;
  place.rows = header.shape.rows;
  place.spacing_x_m = header.spacing_x_m;
  place.spacing_z_m = header.spacing_z_m;
  place.georeference = header.georeference;
  return place;
}

PostWindow window_around(const TileStoreHeader& header, double x_m, double z_m, double radius_m) {
  const auto range = [radius_m](double place_m, double spacing_m, int posts) {
    const double first = std::floor((place_m - radius_m) / spacing_m),
                 last = std::ceil((place_m + radius_m) / spacing_m);
    const int low = static_cast<int>(std::clamp(first, 0.0, posts - 2.0));
    return std::pair(low, static_cast<int>(std::clamp(last, low + 1.0, posts - 1.0)) - low + 1);
  };
  const auto [first_column, columns] = range(x_m, header.spacing_x_m, header.shape.columns);
  const auto [first_row, rows] = range(z_m, header.spacing_z_m, header.shape.rows);
  return {first_column, first_row, columns, rows};
}

HeightMap read_window(const TileStore& store, const PostWindow& window) {
  HeightMap map = place_of(store.header());
  map.columns = window.columns;
  map.rows = window.rows;
  map.georeference.origin_x += window.first_column * map.georeference.step_x;
  map.georeference.origin_y += window.first_row * map.georeference.step_y;
  map.heights_m.resize(static_cast<std::size_t>(window.columns) * static_cast<std::size_t>(window.rows));
  const TileSetShape& shape = store.header().shape;
  const int last_column = window.first_column + window.columns - 1,
            last_row = window.first_row + window.rows - 1;
  const auto copy = [&](const HeightTile& tile) {
    const int left = tile.key.column * tile_cells, top = tile.key.row * tile_cells;
    const int first = std::max(left, window.first_column), last = std::min(left + tile_cells, last_column);
    if (!tile.is_void.empty()) map.is_void.resize(map.heights_m.size());
    for (int row = std::max(top, window.first_row); row <= std::min(top + tile_cells, last_row); ++row) {
      const auto from = static_cast<std::ptrdiff_t>(row - top) * tile_posts + first - left;
      const auto to =
          static_cast<std::ptrdiff_t>(map.index(first - window.first_column, row - window.first_row));
      std::copy_n(tile.highest_m.begin() + from, last - first + 1, map.heights_m.begin() + to);
      if (!tile.is_void.empty())
        std::copy_n(tile.is_void.begin() + from, last - first + 1, map.is_void.begin() + to);
    }
  };
  const auto last_tile = [](int last_post, int tiles) { return std::min(last_post / tile_cells, tiles - 1); };
  for (int row = window.first_row / tile_cells; row <= last_tile(last_row, shape.tiles_z(0)); ++row) {
    for (int column = window.first_column / tile_cells; column <= last_tile(last_column, shape.tiles_x(0));
         ++column) {
      copy(store.read({0, column, row}));
    }
  }
  return map;
}

}  // namespace offing::scene
